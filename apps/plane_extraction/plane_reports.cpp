#include "plane_reports.h"

#include "stage_reports.h"

#include <algorithm>
#include <cstdio>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_lines = 20, lines_of_many = 5;

std::string
describe(const PlanePatch& plane)
{
  // adding zero removes the sign of negative zeros
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

void
tellInSpace(Tool& tool, const PlaneMappingReport& report)
{
  nlohmann::ordered_json& details = tool.details();
  if (report.consolidation)
    tellConsolidation(tool, *report.consolidation);
  else if (report.noise_scale)
    tool.tell("consolidated", "no, the points lie close enough to their surface");
  if (report.mesh)
    details["mesh"] = jsonOf(*report.mesh);
  details["votes"] = jsonOf(*report.votes);
  details["report"] = jsonOf(*report.planes);
}

void
tellInPicture(Tool& tool, const PlaneMappingReport& report)
{
  nlohmann::ordered_json& details = tool.details();
  tellDepthNoise(tool, report.depth_planes->noise);
  details["report"] = jsonOf(*report.depth_planes);
  if (report.refinement)
    tellRefinement(tool, *report.refinement);
  if (report.mesh)
    details["mesh"] = jsonOf(*report.mesh);
  if (report.votes)
    details["votes"] = jsonOf(*report.votes);
}

} // namespace

void
tellMapping(Tool& tool, const PlaneMappingReport& report)
{
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  if (report.depth_planes)
    tellInPicture(tool, report);
  else
    tellInSpace(tool, report);
  for (const auto& [step, seconds] : report.seconds)
    tool.report().seconds.emplace_back(step, seconds);
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
  // they are sorted by decreasing area
  const std::size_t listed = planes.size() <= max_lines ? planes.size() : lines_of_many;
  for (std::size_t id = 0; id < listed; ++id)
    tool.tell("plane " + std::to_string(id), describe(planes[id]));
  if (listed < planes.size())
    tool.tell("further planes",
              std::to_string(planes.size() - listed) + " smaller ones, in the file");
}

} // namespace pcl::acmap
