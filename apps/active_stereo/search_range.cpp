#include "search_range.h"

#include "tool.h"

#include <pcl/core/rig_cameras.h>
#include <pcl/stereo/matched_disparity.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

// supported by TrinocularMatching
constexpr int fewest_disparities = 8;
constexpr int max_disparities = 1024;

} // namespace

double
depthOf(const TrinocularRig& rig, double disparity)
{
  return rig.focal_length * disparityBaseline(rig) / disparity;
}

SearchRange
disparitiesBetween(const TrinocularRig& rig, double nearest, double farthest)
{
  const double longest =
      (hasCamera(rig, RigCamera::Horizontal) ? rig.width : rig.height) - 1.0;
  // the conversion between depth and disparity is its own inverse
  const double from = std::floor(depthOf(rig, farthest)) - 1.0;
  if (from > longest)
    throw UsageError("--max-depth: at " + shortNumber(farthest) +
                     " m disparities are longer than the image, " +
                     std::to_string(static_cast<long>(longest)) +
                     " px; the rig's baseline is " +
                     shortNumber(disparityBaseline(rig)) + " m");
  const double to = std::min(std::ceil(depthOf(rig, nearest)) + 1.0, longest);
  SearchRange range;
  range.least = static_cast<int>(std::max(from, 0.0));
  range.count = std::clamp(
      static_cast<int>(to) - range.least + 1, fewest_disparities, max_disparities);
  return range;
}

} // namespace pcl::acmap
