#include "spacing.h"

#include "ball_visit.h"

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
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t j = first; j < end; ++j) {
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
  visitBall(tree, i, centre, radius, visit);
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
  const auto leaves = static_cast<std::size_t>(tree.leafCount());
  spacing.nearest.resize(leaves);
  spacing.eighth.resize(leaves);
  parallelForChunks(leaves, [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l) {
      const std::int32_t first_point = tree.firstOfLeaf(static_cast<std::int32_t>(l));
      const std::int32_t end_point = tree.firstOfLeaf(static_cast<std::int32_t>(l + 1));
      const std::int32_t quarter = (end_point - first_point) / 4;
      const auto first = nearestSquared(tree, first_point + quarter);
      const auto second = nearestSquared(tree, end_point - 1 - quarter);
      spacing.nearest[l] = std::sqrt(std::min(first.front(), second.front()));
      spacing.eighth[l] = std::sqrt(std::min(first.back(), second.back()));
    }
  });
  return spacing;
}

} // namespace pcl::acmap::dewall
