#include "stage_reports.h"

#include "tool.h"

namespace pcl::acmap {

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
