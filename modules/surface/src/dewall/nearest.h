#pragma once

#include "point_tree.h"

namespace pcl::acmap::dewall {

/** \brief Point nearest to tree point \a i within a distance among those that \a accept
 * lets pass, -1 where there is none. Ties go to the lower index. */
template <typename Accept>
std::int32_t
nearestPoint(const PointTree& tree, std::int32_t i, double within, const Accept& accept)
{
  const Eigen::Vector3d centre = tree.position(i);
  double radius = within;
  double best_squared = within * within;
  std::int32_t best = -1;
  const auto visit = [&](const PointTree::Node& leaf) {
    for (std::int32_t j = leaf.begin; j < leaf.end; ++j) {
      if (j == i)
        continue;
      const double squared = (tree.position(j) - centre).squaredNorm();
      const bool nearer =
          squared < best_squared || (squared == best_squared && (best < 0 || j < best));
      if (nearer && accept(j)) {
        best = j;
        best_squared = squared;
        radius = std::sqrt(squared);
      }
    }
  };
  tree.visitBall(
      i, centre, radius, [](const PointTree::Node&) { return true; }, visit);
  return best;
}

} // namespace pcl::acmap::dewall
