#include "report/closing_lines.h"
#include "report/map_details.h"
#include "report/report_page.h"

#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/json_text.h>
#include <pcl/core/output_file.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/pipeline/map_report.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace pcl {

namespace {

using Json = nlohmann::ordered_json;

Json
stageOf(const char* name, const Report& report, Json details)
{
  return {{"name", name},
          {"seconds", acmap::secondsOf(report)},
          {"warnings", report.remarks},
          {"details", std::move(details)}};
}

Json
rectificationStage(const EntropyRectificationReport& report)
{
  Json details = acmap::fieldsOf(report, {{"steps"}});
  details["steps"] = acmap::columnsOf(report.steps);
  return stageOf("rectification", report, std::move(details));
}

} // namespace

MapReport::MapReport(std::string text)
: text_(std::move(text))
{
  const Json json = acmap::parsedJson(text_);
  if (json.is_discarded())
    throw acmap::BadArgument("the report of a map is no JSON");
  text_ = acmap::jsonText(json);
}

MapReport::MapReport(const CompactMap& map, const CompactMappingReport& report)
{
  Json details = acmap::detailsOfMap(map);
  details["plan"] = acmap::detailsOfPlan(map, makeFloorPlan(map));
  details["observations"] = report.merging.observations;
  Json json = {{"version", ACMAP_VERSION},
               {"format", acmap::file_formats::report},
               {"mode", acmap::nameIn(acmap::mapping_mode_names, report.mode)}};
  if (report.quality)
    json["quality"] = acmap::fieldsOf(*report.quality);
  if (report.next_positions)
    json["next_positions"] = acmap::fieldsOf(*report.next_positions);
  for (const char* name : {"planes", "cylinders", "boxes", "recesses"})
    json[name] = details[name].size();
  json["stages"] = Json::array();
  if (report.rectification)
    json["stages"].push_back(rectificationStage(*report.rectification));
  json["stages"].push_back(stageOf("map", report, std::move(details)));
  text_ = acmap::jsonText(json);
}

std::string
MapReport::page(const std::string& folder) const
{
  return acmap::reportPage(acmap::parsedJson(text_), folder);
}

void
MapReport::savePage(const std::string& path, const std::string& folder) const
{
  const std::string html = page(folder);
  acmap::OutputFile file(path);
  file.write(html.data(), html.size());
  file.commit();
}

std::vector<std::pair<std::string, std::string>>
MapReport::summary() const
{
  return acmap::closingLines(acmap::parsedJson(text_));
}

MapReport
loadMapReport(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file)
    throw InputFileException(path + ": cannot be read");
  try {
    return MapReport(std::move(text));
  }
  catch (const BadArgumentException&) {
    throw InputFileException(path + ": is no JSON");
  }
}

namespace acmap {

std::string
mapDetailsText(const CompactMap& map)
{
  return jsonText(detailsOfMap(map));
}

std::string
planDetailsText(const CompactMap& map, const FloorPlan& plan)
{
  return jsonText(detailsOfPlan(map, plan));
}

} // namespace acmap

} // namespace pcl
