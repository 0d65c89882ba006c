#include "page_seconds.h"

#include "page_text.h"
#include "page_values.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::pair<std::string, double>>
secondsOfSteps(const Json& seconds)
{
  std::vector<std::pair<std::string, double>> steps;
  for (const auto& [name, value] : seconds.items())
    if (const auto number = numberOf(seconds, name))
      steps.emplace_back(name, std::max(*number, 0.0));
  return steps;
}

bool
isPartOf(const std::string& step, const std::vector<StageSeconds>& stages)
{
  return std::any_of(stages.begin(), stages.end(), [&](const StageSeconds& stage) {
    return stage.name == step ||
           std::any_of(stage.steps.begin(), stage.steps.end(), [&](const auto& its) {
             return its.first == step;
           });
  });
}

std::string
row(const std::string& kind,
    const std::string& name,
    double seconds,
    const std::string& note,
    double longest)
{
  return "<tr class=\"" + kind + "\"><th scope=\"row\">" + htmlText(name) +
         "</th><td class=\"number\">" + secondsText(seconds) + note +
         "</td><td class=\"bars\"><span class=\"bar\" style=\"width:" +
         fixedText(longest > 0 ? 100 * seconds / longest : 0, 1) +
         "%\"></span></td></tr>\n";
}

std::string
rowsOf(const StageSeconds& stage, double longest)
{
  const std::string reused = stage.is_reused ? " reused" : "";
  std::string rows = row("stage" + reused,
                         stage.name,
                         stage.total(),
                         stage.is_reused ? "<br><em>reused</em>" : "",
                         longest);
  for (const auto& [name, seconds] : stage.steps)
    rows += row("step" + reused, name, seconds, "", longest);
  return rows;
}

} // namespace

double
StageSeconds::total() const
{
  double sum = 0;
  for (const auto& step : steps)
    sum += step.second;
  return sum;
}

double
RunSeconds::total() const
{
  double sum = 0;
  for (const StageSeconds& stage : stages)
    sum += stage.is_reused ? 0 : stage.total();
  return sum;
}

RunSeconds
secondsOfRun(const Json& report)
{
  RunSeconds run;
  for (const Json& json : fieldOf(report, "stages")) {
    const Json& reused = fieldOf(json, "reused");
    StageSeconds stage;
    stage.name = textOf(json, "name");
    stage.is_reused = reused.is_boolean() && reused.get<bool>();
    stage.steps = secondsOfSteps(fieldOf(json, "seconds"));
    if (!stage.steps.empty())
      run.stages.push_back(stage);
  }
  StageSeconds rest;
  rest.name = "rest of the run";
  for (const auto& step : secondsOfSteps(fieldOf(report, "seconds")))
    if (!isPartOf(step.first, run.stages))
      rest.steps.push_back(step);
  if (!rest.steps.empty())
    run.stages.push_back(rest);
  return run;
}

std::string
secondsTable(const Json& report)
{
  const RunSeconds run = secondsOfRun(report);
  if (run.stages.empty())
    return {};
  double longest = 0;
  for (const StageSeconds& stage : run.stages)
    longest = std::max(longest, stage.total());
  std::string html =
      "<h2>Time</h2>\n<table class=\"seconds\">\n<thead><tr><th>stage</th>"
      "<th class=\"number\">time</th><th></th></tr></thead>\n<tbody>\n";
  for (const StageSeconds& stage : run.stages)
    html += rowsOf(stage, longest);
  return html +
         "</tbody>\n<tfoot><tr><th scope=\"row\">this run</th><td class=\"number\">" +
         secondsText(run.total()) + "</td><td></td></tr></tfoot>\n</table>\n";
}

} // namespace pcl::acmap
