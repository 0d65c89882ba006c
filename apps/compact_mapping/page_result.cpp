#include "report_page.h"

#include "page_seconds.h"
#include "page_text.h"
#include "page_values.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

std::string
strong(const std::string& text)
{
  return "<strong>" + text + "</strong>";
}

/** Number and noun: "31 planes", "1 plane". */
std::string
several(double count, const std::string& noun)
{
  return numberText(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string
planesSentence(const Json& report)
{
  const auto planes = countOf(report, "planes");
  if (!planes)
    return {};
  std::string text = strong(several(*planes, "plane"));
  const auto observations = countOf(report, "observations");
  const auto points = countOf(report, "finite_points");
  if (observations)
    text += " from " + several(*observations, "observation");
  if (points)
    text += (observations ? " with " : " from ") + several(*points, "point");
  const auto on_planes = countOf(report, "points_on_planes");
  if (on_planes && points && *points > 0)
    text += ", " + numberText(100 * *on_planes / *points) + " % of them on a plane";
  return text + ". ";
}

std::string
ratio(double raw, double size)
{
  return fixedText(std::floor(raw / std::max(size, 1.0)), 0) + " : 1";
}

std::string
compactnessSentence(const Json& report)
{
  const Json& bytes = detailOf(report, "bytes");
  const auto raw = numberOf(bytes, "raw");
  const auto map = numberOf(bytes, "map.glb");
  const auto geometry = numberOf(bytes, "geometry");
  if (raw && map) {
    std::string text = "Compactness " + strong(ratio(*raw, *map)) +
                       " with texture: " + bytesText(*raw) + " of points became " +
                       bytesText(*map);
    if (geometry)
      text += "; " + ratio(*raw, *geometry) + " the geometry alone";
    return text + ". ";
  }
  const auto compactness = numberOf(fieldOf(report, "truth"), "compactness");
  return compactness ? "Compactness " + strong(ratio(*compactness, 1)) + ". " : "";
}

std::string
effortSentence(const Json& report)
{
  const RunSeconds seconds = secondsOfRun(report);
  const auto memory = numberOf(report, "peak_memory_bytes");
  std::string text;
  if (!seconds.stages.empty())
    text = "Took " + secondsText(seconds.total());
  if (memory)
    text += (text.empty() ? "Took" : " and") + (" at most " + bytesText(*memory)) +
            " of memory";
  if (text.empty())
    return {};
  const auto reused = std::count_if(seconds.stages.begin(),
                                    seconds.stages.end(),
                                    [](const auto& stage) { return stage.is_reused; });
  if (reused > 0)
    text += ", with " + several(static_cast<double>(reused), "stage") +
            " reused from an earlier run";
  return text + ". ";
}

} // namespace

std::string
resultParagraph(const Json& report)
{
  std::string text =
      planesSentence(report) + compactnessSentence(report) + effortSentence(report);
  if (text.empty())
    return {};
  text.pop_back(); // the space after the last sentence
  return "<p class=\"result\">" + text + "</p>\n";
}

std::string
warningBox(const Json& report)
{
  std::vector<std::string> lines, told;
  const auto add = [&](const std::string& stage, const std::string& warning) {
    if (std::find(told.begin(), told.end(), warning) != told.end())
      return;
    told.push_back(warning);
    lines.push_back((stage.empty() ? "" : strong(htmlText(stage)) + ": ") +
                    htmlText(warning));
  };
  for (const Json& stage : fieldOf(report, "stages"))
    for (const std::string& warning : textsOf(stage, "warnings"))
      add(textOf(stage, "name"), warning);
  for (const std::string& warning : textsOf(report, "remarks"))
    add("", warning);
  if (lines.empty())
    return "<p>No warnings.</p>\n";
  std::string html = "<section class=\"warnings\">\n<h2>" +
                     several(static_cast<double>(lines.size()), "warning") +
                     "</h2>\n<ul>\n";
  for (const std::string& line : lines)
    html += "<li>" + line + "</li>\n";
  return html + "</ul>\n</section>\n";
}

} // namespace pcl::acmap
