#include "observation_maker.h"

#include <cmath>

namespace pcl::acmap {

ObservationMaker::ObservationMaker(const TrinocularRig& rig,
                                   const SearchRange& range,
                                   const StereoOptions& options,
                                   unsigned threads)
{
  TrinocularMatching matching;
  matching.setXOffset(range.least);
  matching.setMaxDisparity(range.count);
  if (options.correlation)
    matching.setCorrelationThreshold(*options.correlation);
  if (options.texture)
    matching.setPeakFilter(*options.texture);
  fusion_.setMatching(matching);
  fusion_.setInputRig(rig);
  fusion_.setMethod(disparityFusionMethod(options.method));
  fusion_.setPassive(options.isPassive());
  fusion_.setNumberOfThreads(threads);
  projection_.setInputRig(rig);
  projection_.setMinimumDepth(options.nearest);
  projection_.setMaximumDepth(options.farthest);
  projection_.setNumberOfThreads(threads);
}

MadeObservation
ObservationMaker::make(const ObservationShots& shots, const ProgressCallback& progress)
{
  // most of the time is spent in the step that does the matching
  const bool at_once = fusion_.getMethod() == DisparityFusion::Method::SpaceTime;
  const double share_of_shots = at_once ? 0.05 : 0.95;
  double begin = 0.0;
  double share = share_of_shots / static_cast<double>(shots.frames.size());
  fusion_.setProgressCallback([&](double fraction, const std::string& step) {
    return progress(begin + share * fraction, step);
  });

  MadeObservation made;
  fusion_.clear();
  for (const TrinocularFrame::ConstPtr& frame : shots.frames) {
    fusion_.addShot(frame);
    begin += share;
  }
  begin = share_of_shots;
  share = 1.0 - share_of_shots;
  fusion_.fuse(made.matched);
  fusion_.setProgressCallback({}); // the callback refers to local variables
  made.fusion = fusion_.getReport();
  projection_.project(made.matched, fusion_.getColor(), made.cloud);
  made.projection = projection_.getReport();
  return made;
}

std::size_t
disparityMemory(const TrinocularRig& rig, const SearchRange& range)
{
  constexpr double bytes = 4.0; // one disparity of a pair
  // the vertical pair has disparities in proportion to its baseline
  const double pairs =
      (std::abs(rig.baseline_horizontal) + std::abs(rig.baseline_vertical)) /
      disparityBaseline(rig);
  return static_cast<std::size_t>(bytes * pairs * rig.width * rig.height * range.count);
}

} // namespace pcl::acmap
