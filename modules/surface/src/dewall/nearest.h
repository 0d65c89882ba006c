#pragma once

#include "point_tree.h"

#include <limits>
#include <vector>

namespace pcl::acmap::dewall {

/** \brief Distance from tree point \a i to its k-th neighbour, metres; to the farthest
 * point where there are fewer, 0 where there is none. */
inline double
distanceToNeighbour(const PointTree& tree, std::int32_t i, std::size_t k)
{
  const Eigen::Vector3d centre = tree.position(i);
  std::vector<double> nearest; // squared, ascending, at most k
  double radius = std::numeric_limits<double>::max();
  const auto visit = [&](const PointTree::Node& leaf) {
    for (std::int32_t j = leaf.begin; j < leaf.end; ++j) {
      if (j == i)
        continue;
      const double squared = (tree.position(j) - centre).squaredNorm();
      if (nearest.size() == k && squared >= nearest.back())
        continue;
      nearest.insert(std::lower_bound(nearest.begin(), nearest.end(), squared),
                     squared);
      if (nearest.size() > k)
        nearest.pop_back();
      if (nearest.size() == k)
        radius = std::sqrt(nearest.back());
    }
  };
  tree.visitBall(
      i, centre, radius, [](const PointTree::Node&) { return true; }, visit);
  return nearest.empty() ? 0.0 : std::sqrt(nearest.back());
}

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
