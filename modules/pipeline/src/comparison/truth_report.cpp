#include <pcl/core/impl/json_text.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/map_comparison.h>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

Json
deviationJson(const PlaneDeviation& plane)
{
  if (!plane.finder)
    return {{"name", plane.name}, {"plane", nullptr}};
  return {{"name", plane.name},
          {"plane", *plane.finder},
          {"angle_deg", plane.angle},
          {"offset_m", plane.offset},
          {"overlap_m2", plane.overlap}};
}

Json
deviationJson(const MapDeviation& deviation)
{
  return {{"main_planes_found", deviation.found},
          {"main_planes", deviation.planes.size()},
          {"mean_angle_deg", deviation.mean_angle},
          {"largest_angle_deg", deviation.largest_angle},
          {"mean_offset_m", deviation.mean_offset},
          {"largest_offset_m", deviation.largest_offset},
          {"ate_before_m", deviation.ate_before},
          {"ate_after_m", deviation.ate_after}};
}

} // namespace

std::string
truthDetailsText(const MapFigures& figures)
{
  Json json = deviationJson(figures.aligned);
  json["compactness"] = figures.compactness;
  json["planes"] = Json::array();
  for (const PlaneDeviation& plane : figures.aligned.planes)
    json["planes"].push_back(deviationJson(plane));
  json["from_first"] = deviationJson(figures.from_first);
  return jsonText(json);
}

std::vector<std::pair<std::string, std::string>>
truthSummary(const MapFigures& figures)
{
  const MapDeviation& it = figures.aligned;
  std::string planes =
      std::to_string(it.found) + " of " + std::to_string(it.planes.size()) + " found";
  if (it.found > 0)
    planes += ", " + shortNumber(it.mean_angle) + " degrees and " +
              shortNumber(1000 * it.mean_offset) + " mm off (means), at most " +
              shortNumber(it.largest_angle) + " degrees and " +
              shortNumber(1000 * it.largest_offset) + " mm";
  return {{"true planes", planes},
          {"ATE",
           shortNumber(it.ate_before) + " m before rectification, " +
               shortNumber(it.ate_after) + " m after"}};
}

} // namespace pcl::acmap
