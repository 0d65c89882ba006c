#include "stage_reports.h"

#include "tool.h"

namespace pcl::acmap {

nlohmann::ordered_json
jsonOf(const ConsolidationReport& report)
{
  return {{"points", report.points},
          {"invalid_points", report.invalid_points},
          {"distant_points", report.distant_points},
          {"voxels", report.voxels},
          {"representatives", report.representatives},
          {"two_sided_voxels", report.two_sided_voxels},
          {"narrowed_windows", report.narrowed_windows},
          {"without_normal", report.without_normal},
          {"sensors_fit", report.sensors_fit},
          {"voxel_size", report.voxel_size},
          {"sigma", report.sigma},
          {"residual", report.residual},
          {"seconds", secondsOf(report)}};
}

nlohmann::ordered_json
jsonOf(const DeWallReport& report)
{
  return {{"points", report.points},
          {"invalid_points", report.invalid_points},
          {"duplicate_points", report.duplicate_points},
          {"used_points", report.used_points},
          {"clusters", report.clusters},
          {"triangles", report.triangles},
          {"edges", report.edges},
          {"boundary_edges", report.boundary_edges},
          {"components", report.components},
          {"refused_moebius", report.refused_moebius},
          {"removed_fans", report.removed_fans},
          {"median_spacing", report.median_spacing},
          {"least_maximum_edge", report.least_maximum_edge},
          {"largest_maximum_edge", report.largest_maximum_edge},
          {"seconds", secondsOf(report)}};
}

nlohmann::ordered_json
secondsOf(const Report& report)
{
  nlohmann::ordered_json seconds = nlohmann::ordered_json::object();
  for (const auto& [step, its_seconds] : report.seconds)
    seconds[step] = its_seconds;
  return seconds;
}

std::string
percent(std::size_t part, std::size_t whole)
{
  return shortNumber(whole ? 100.0 * static_cast<double>(part) /
                                 static_cast<double>(whole)
                           : 0.0) +
         " %";
}

} // namespace pcl::acmap
