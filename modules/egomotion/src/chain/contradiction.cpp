#include "chain/contradiction.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief Maximum difference between depths on a ray for points of the same surface, as
 * a share of the depth.
 * \param[in] distance distance of the plane from the camera, metres */
double
mostDifference(const SurfaceBlock& one, const SurfaceBlock& other, double distance)
{
  constexpr double least = 0.02;       // relative to the depth
  constexpr double max_deviations = 2; // standard deviations of the noise
  return std::max(least,
                  max_deviations * std::sqrt(one.variance + other.variance) /
                      std::abs(distance));
}

/** \brief Share of the blocks of one view that contradict the other view. */
double
shareOf(const EgomotionView& one,
        const EgomotionView& other,
        const Eigen::Isometry3d& T_other_one)
{
  if (!other.pinhole)
    return 0;
  std::size_t agreeing = 0, contradicted = 0;
  for (const SurfaceBlock& block : one.surfaces.blocks) {
    if (!block.isPlane())
      continue;
    const Eigen::Vector3d point = T_other_one * block.point;
    if (point.z() <= 0)
      continue;
    const SurfaceBlock* seen = other.surfaces.at(other.pinhole->project(point));
    if (!seen || !seen->isPlane())
      continue;
    const double depth = seen->normal.dot(seen->center);
    const double behind = seen->normal.dot(point) / depth - 1;
    const double most = mostDifference(block, *seen, depth);
    contradicted += behind < -most;
    agreeing += std::abs(behind) <= most;
  }
  const std::size_t told = agreeing + contradicted;
  return told > 0 ? static_cast<double>(contradicted) / static_cast<double>(told) : 0;
}

} // namespace

double
contradictedShare(const EgomotionView& source,
                  const EgomotionView& target,
                  const Eigen::Isometry3d& T_target_source)
{
  return std::max(shareOf(source, target, T_target_source),
                  shareOf(target, source, T_target_source.inverse()));
}

} // namespace pcl::acmap
