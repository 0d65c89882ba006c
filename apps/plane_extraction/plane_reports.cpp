#include "plane_reports.h"

#include "stage_reports.h"

#include <algorithm>
#include <cstdio>

namespace pcl::acmap {

namespace {

constexpr std::size_t most_lines = 20, lines_of_many = 5;

std::string
describe(const PlanePatch& plane)
{
  // adding zero takes the minus from zeros
  const Eigen::Array3d n =
      (1000 * plane.coefficients.head<3>().array()).round() / 1000 + 0.0;
  char text[128];
  std::snprintf(text,
                sizeof text,
                "%.3g m2, rmse %.3g mm, normal %.3f %.3f %.3f",
                plane.area,
                1000 * plane.rms,
                n[0],
                n[1],
                n[2]);
  return text;
}

} // namespace

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

void
tellPlanes(Tool& tool,
           const std::vector<PlanePatch>& planes,
           const std::vector<std::int32_t>& labels,
           std::size_t points)
{
  const auto on_planes = static_cast<std::size_t>(std::count_if(
      labels.begin(), labels.end(), [](auto label) { return label >= 0; }));
  tool.details()["input_points"] = labels.size();
  tool.details()["finite_points"] = points;
  tool.details()["points_on_planes"] = on_planes;
  tool.tell("planes", std::to_string(planes.size()));
  tool.tell("on planes", percent(on_planes, points) + " of the points");
  // they come by falling area
  const std::size_t listed =
      planes.size() <= most_lines ? planes.size() : lines_of_many;
  for (std::size_t id = 0; id < listed; ++id)
    tool.tell("plane " + std::to_string(id), describe(planes[id]));
  if (listed < planes.size())
    tool.tell("further planes",
              std::to_string(planes.size() - listed) + " smaller ones, in the file");
}

} // namespace pcl::acmap
