#pragma once

#include "ball_visit.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Returns the nearest point to tree point \a i within a distance, among those
 * for which \a accept returns true; -1 if there is none. Ties are resolved by the lower
 * index. */
template <typename Accept>
std::int32_t
nearestPoint(const PointTree& tree, std::int32_t i, double within, const Accept& accept)
{
  const Eigen::Vector3d centre = tree.position(i);
  double radius = within;
  double best_squared = within * within;
  std::int32_t best = -1;
  visitBall(
      tree, i, centre, radius, [&](std::int32_t, std::int32_t first, std::int32_t end) {
        for (std::int32_t j = first; j < end; ++j) {
          if (j == i)
            continue;
          const double squared = (tree.position(j) - centre).squaredNorm();
          const bool nearer = squared < best_squared ||
                              (squared == best_squared && (best < 0 || j < best));
          if (nearer && accept(j)) {
            best = j;
            best_squared = squared;
            radius = std::sqrt(squared);
          }
        }
      });
  return best;
}

} // namespace pcl::acmap::ACMAP_DEWALL
