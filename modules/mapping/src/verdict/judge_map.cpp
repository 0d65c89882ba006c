#include "independent_estimate.h"

#include <pcl/mapping/impl/map_verdict_kernel.h>

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
  static_cast<Report&>(made) = std::move(report);
  report = std::move(made);
}

} // namespace pcl::acmap
