#include "stage_reports.h"

namespace pcl::acmap {

void
tellConsolidation(const ConsolidationReport& report, StageLog& log)
{
  log.details["consolidation"] = jsonOf(report);
  log.tell("consolidated",
           std::to_string(report.points) + " points to " +
               std::to_string(report.representatives) + ", voxels of " +
               shortNumber(report.voxel_size) + " m, noise " +
               shortNumber(1000 * report.sigma) + " to about " +
               shortNumber(1000 * report.residual) + " mm");
}

void
tellDepthNoise(const NoiseScale::InverseDepth& noise, StageLog& log)
{
  log.details["depth"] = fieldsOf(noise);
  log.details["depth"]["sigma"] = noise.sigma();
  const auto at = [](double inverse_depth, double depth) {
    return shortNumber(1000 * inverse_depth * depth * depth) + " mm";
  };
  log.tell("depth",
           (noise.step > 0 ? "quantised, steps of " + at(noise.step, 2) + " at 2 m, " +
                                 at(noise.step, 4) + " at 4 m"
                           : std::string("not quantised")) +
               "; noise " + at(noise.sigma(), 2) + " at 2 m, " + at(noise.sigma(), 4) +
               " at 4 m");
}

void
tellRefinement(const DepthRefinementReport& report, StageLog& log)
{
  log.details["refinement"] = jsonOf(report, {{"noise"}}); // told by the depth
  const std::size_t measured_points = report.points - report.invalid_points;
  log.tell("refined",
           percent(report.on_planes, measured_points) + " of the points onto " +
               std::to_string(report.planes) + " planes, " +
               percent(report.smoothed, measured_points) + " onto their neighbourhood");
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
