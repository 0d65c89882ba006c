#include "spacing.h"

#include <pcl/core/parallel.h>

#include <limits>

namespace pcl::acmap::dewall {

namespace {

constexpr std::size_t most_neighbours = 8;

/** \brief Squared distances to the nearest neighbours, ascending; fewer in a small tree. */
std::vector<double>
nearestSquared(const PointTree& tree, std::int32_t i)
{
  const Eigen::Vector3d centre = tree.position(i);
  std::vector<double> nearest;
  nearest.reserve(most_neighbours + 1);
  double radius = std::numeric_limits<double>::max();
  const auto visit = [&](const PointTree::Node& leaf) {
    for (std::int32_t j = leaf.begin; j < leaf.end; ++j) {
      if (j == i)
        continue;
      const double squared = (tree.position(j) - centre).squaredNorm();
      if (nearest.size() == most_neighbours && squared >= nearest.back())
        continue;
      nearest.insert(std::lower_bound(nearest.begin(), nearest.end(), squared),
                     squared);
      if (nearest.size() > most_neighbours)
        nearest.pop_back();
      if (nearest.size() == most_neighbours)
        radius = std::sqrt(nearest.back());
    }
  };
  tree.visitBall(
      i, centre, radius, [](const PointTree::Node&) { return true; }, visit);
  return nearest;
}

} // namespace

double
Spacing::median() const
{
  std::vector<double> sorted = nearest;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

Spacing
measureSpacing(const PointTree& tree)
{
  Spacing spacing;
  for (std::int32_t n = 0; n < tree.nodeCount(); ++n)
    if (tree.node(n).isLeaf())
      spacing.leaves.push_back(n);
  spacing.nearest.resize(spacing.leaves.size());
  spacing.eighth.resize(spacing.leaves.size());
  parallelForChunks(spacing.leaves.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l) {
      const PointTree::Node& leaf = tree.node(spacing.leaves[l]);
      const auto first = nearestSquared(tree, leaf.begin + leaf.size() / 4);
      const auto second = nearestSquared(tree, leaf.end - 1 - leaf.size() / 4);
      spacing.nearest[l] = std::sqrt(std::min(first.front(), second.front()));
      spacing.eighth[l] = std::sqrt(std::min(first.back(), second.back()));
    }
  });
  return spacing;
}

} // namespace pcl::acmap::dewall
