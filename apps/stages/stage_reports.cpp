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
jsonOf(const VotingReport& report)
{
  return {{"vertices", report.vertices},
          {"invalid_points", report.invalid_points},
          {"triangles", report.triangles},
          {"degenerate_triangles", report.degenerate_triangles},
          {"surface", report.surface},
          {"crease", report.crease},
          {"corner", report.corner},
          {"unknown", report.unknown},
          {"radius", report.radius},
          {"mean_edge", report.mean_edge},
          {"sigma", report.sigma},
          {"seconds", secondsOf(report)}};
}

nlohmann::ordered_json
jsonOf(const PlaneClusteringReport& report)
{
  return {{"points", report.points},
          {"hypotheses", report.hypotheses},
          {"planes", report.planes},
          {"points_on_planes", report.points_on_planes},
          {"small_regions", report.small_regions},
          {"curved_regions", report.curved_regions},
          {"points_on_curved", report.points_on_curved},
          {"refuted_regions", report.refuted_regions},
          {"merged", report.merged},
          {"regular_planes", report.regular_planes},
          {"largest_turn", report.largest_turn},
          {"spacing", report.spacing},
          {"sigma", report.sigma},
          {"plane_distance", report.plane_distance},
          {"seconds", secondsOf(report)}};
}

nlohmann::ordered_json
jsonOf(const DepthPlaneReport& report)
{
  return {{"points", report.points},
          {"invalid_points", report.invalid_points},
          {"planes", report.planes},
          {"points_on_planes", report.points_on_planes},
          {"small_regions", report.small_regions},
          {"curved_regions", report.curved_regions},
          {"merged", report.merged},
          {"regular_planes", report.regular_planes},
          {"largest_turn", report.largest_turn},
          {"seconds", secondsOf(report)}};
}

nlohmann::ordered_json
jsonOf(const DepthRefinementReport& report)
{
  return {{"points", report.points},
          {"invalid_points", report.invalid_points},
          {"on_planes", report.on_planes},
          {"smoothed", report.smoothed},
          {"withdrawn", report.withdrawn},
          {"planes", report.planes},
          {"seconds", secondsOf(report)}};
}

void
tellConsolidation(Tool& tool, const ConsolidationReport& report)
{
  tool.details()["consolidation"] = jsonOf(report);
  tool.tell("consolidated",
            std::to_string(report.points) + " points to " +
                std::to_string(report.representatives) + ", voxels of " +
                shortNumber(report.voxel_size) + " m, noise " +
                shortNumber(1000 * report.sigma) + " to about " +
                shortNumber(1000 * report.residual) + " mm");
}

void
tellDepthNoise(Tool& tool, const NoiseScale::InverseDepth& noise)
{
  tool.details()["depth"] = {{"step", noise.step},
                             {"independent_sigma", noise.independent},
                             {"correlated_sigma", noise.correlated},
                             {"sigma", noise.sigma()}};
  const auto at = [](double inverse_depth, double depth) {
    return shortNumber(1000 * inverse_depth * depth * depth) + " mm";
  };
  tool.tell("depth",
            (noise.step > 0 ? "quantised, steps of " + at(noise.step, 2) + " at 2 m, " +
                                  at(noise.step, 4) + " at 4 m"
                            : std::string("not quantised")) +
                "; noise " + at(noise.sigma(), 2) + " at 2 m, " + at(noise.sigma(), 4) +
                " at 4 m");
}

void
tellRefinement(Tool& tool, const DepthRefinementReport& report)
{
  tool.details()["refinement"] = jsonOf(report);
  const std::size_t measured_points = report.points - report.invalid_points;
  tool.tell("refined",
            percent(report.on_planes, measured_points) + " of the points onto " +
                std::to_string(report.planes) + " planes, " +
                percent(report.smoothed, measured_points) +
                " onto their neighbourhood");
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
