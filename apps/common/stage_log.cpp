#include "stage_log.h"

#include "exit_code.h"

#include <pcl/core/fields_json.h>

#include <algorithm>

namespace pcl::acmap {

using Json = nlohmann::ordered_json;

Json
jsonOf(const StageLog& log)
{
  Json summary = Json::array();
  for (const auto& [name, value] : log.lines)
    summary.push_back({name, value});
  return {{"seconds", secondsOf(log.report)},
          {"summary", summary},
          {"warnings", log.report.remarks},
          {"contradiction", log.contradiction},
          {"details", log.details}};
}

StageLog
stageLogIn(const Json& json)
{
  StageLog log;
  for (const auto& [step, time] : json.at("seconds").items())
    log.report.seconds.emplace_back(step, time.get<double>());
  for (const Json& line : json.at("summary"))
    log.lines.emplace_back(line.at(0).get<std::string>(),
                           line.at(1).get<std::string>());
  log.report.remarks = json.at("warnings").get<std::vector<std::string>>();
  log.contradiction = json.at("contradiction").get<std::string>();
  log.details = json.at("details").get_ref<const Json::object_t&>();
  return log;
}

double
totalSeconds(const StageLog& log)
{
  double sum = 0;
  for (const auto& step : log.report.seconds)
    sum += step.second;
  return sum;
}

void
StageLog::tell(const std::string& name, const std::string& value)
{
  lines.emplace_back(name, value);
}

void
StageLog::tellSeconds()
{
  tell("seconds", shortNumber(totalSeconds(*this)));
}

void
StageLog::warn(const std::string& remark)
{
  std::vector<std::string>& all = report.remarks;
  if (std::find(all.begin(), all.end(), remark) == all.end())
    all.push_back(remark);
}

void
StageLog::warn(const std::vector<std::string>& remarks)
{
  for (const std::string& remark : remarks)
    warn(remark);
}

void
StageLog::warnOfFirst(std::size_t maximum,
                      const std::vector<std::string>& remarks,
                      const std::string& others)
{
  for (std::size_t i = 0; i < std::min(maximum, remarks.size()); ++i)
    warn(remarks[i]);
  if (remarks.size() > maximum)
    warn(std::to_string(remarks.size() - maximum) + " " + others);
}

void
StageLog::failWithNothing(std::string reason) const
{
  for (const std::string& remark : report.remarks)
    reason += "; " + remark;
  throw NothingFound(reason);
}

} // namespace pcl::acmap
