#include "independent_estimate.h"

#include <pcl/mapping/impl/map_verdict_kernel.h>

#include <algorithm>
#include <utility>

namespace pcl::acmap {

void
judgeMap(const std::vector<LevelledPoints>& observations,
         const std::vector<PlanarPose>& given,
         const std::vector<PlanarPose>& judged,
         const OdometryNoise& noise,
         std::uint64_t seed,
         const Progress& progress,
         MapVerdictReport& report)
{
  MapVerdictReport made;
  if (given.size() < 2)
    made.reasons.emplace_back("one observation: there is nothing to compare it with");
  else if (!areScans(observations))
    made.reasons.emplace_back("the observations are no scans of a planar laser");
  else
    made =
        IndependentEstimate(observations, given, noise, seed, progress).judge(judged);
  for (const LevelledPoints& seen : observations)
    made.invalid_points += static_cast<std::size_t>(
        std::count_if(seen.points.begin(), seen.points.end(), [](const auto& point) {
          return !point.allFinite();
        }));
  if (made.outcome == VerdictOutcome::Undetermined)
    report.remarks.insert(
        report.remarks.end(), made.reasons.begin(), made.reasons.end());
  static_cast<Report&>(made) = std::move(report);
  report = std::move(made);
}

} // namespace pcl::acmap
