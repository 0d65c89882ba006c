#include "spacing.h"

#include "ball_visit.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

constexpr std::size_t max_neighbours = 8;

/** \brief Squared distances to the nearest neighbours, ascending; there are fewer in a
 * small tree. */
std::vector<double>
nearestSquared(const PointTree& tree, std::int32_t i)
{
  const Eigen::Vector3d centre = tree.position(i);
  std::vector<double> nearest;
  nearest.reserve(max_neighbours + 1);
  double radius = std::numeric_limits<double>::max();
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t j = first; j < end; ++j) {
      if (j == i)
        continue;
      const double squared = (tree.position(j) - centre).squaredNorm();
      if (nearest.size() == max_neighbours && squared >= nearest.back())
        continue;
      nearest.insert(std::lower_bound(nearest.begin(), nearest.end(), squared),
                     squared);
      if (nearest.size() > max_neighbours)
        nearest.pop_back();
      if (nearest.size() == max_neighbours)
        radius = std::sqrt(nearest.back());
    }
  };
  visitBall(tree, i, centre, radius, visit);
  return nearest;
}

/** \brief Same, from the results of the caller's search. Invalid distances and those of
 * repeated positions (zero) are ignored. */
std::vector<double>
usableSquared(const std::vector<float>& found)
{
  std::vector<double> squared;
  for (const float distance : found)
    if (std::isfinite(distance) && distance > 0)
      squared.push_back(distance);
  std::sort(squared.begin(), squared.end());
  if (squared.size() > max_neighbours)
    squared.resize(max_neighbours);
  return squared;
}

/** \brief Measures the spacing of a leaf at two of its points, a quarter from either
 * end. */
template <typename Search>
void
measureLeaf(const PointTree& tree,
            std::size_t leaf,
            const Search& search,
            Spacing& spacing)
{
  const auto number = static_cast<std::int32_t>(leaf);
  const std::int32_t first_point = tree.firstOfLeaf(number);
  const std::int32_t end_point = tree.firstOfLeaf(number + 1);
  const std::int32_t quarter = (end_point - first_point) / 4;
  const auto first = search(first_point + quarter);
  const auto second = search(end_point - 1 - quarter);
  spacing.nearest[leaf] = std::sqrt(std::min(first.front(), second.front()));
  spacing.eighth[leaf] = std::sqrt(std::min(first.back(), second.back()));
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
measureSpacing(const PointTree& tree, const NeighbourDistances& neighbours)
{
  Spacing spacing;
  const auto leaves = static_cast<std::size_t>(tree.leafCount());
  spacing.nearest.resize(leaves);
  spacing.eighth.resize(leaves);
  if (neighbours) {
    const auto ask = [&](std::int32_t i) {
      std::vector<double> squared =
          usableSquared(neighbours(tree.source(i), max_neighbours + 1));
      ++spacing.asked;
      spacing.unanswered += squared.empty();
      return squared.empty() ? nearestSquared(tree, i) : squared;
    };
    for (std::size_t leaf = 0; leaf < leaves; ++leaf)
      measureLeaf(tree, leaf, ask, spacing);
    return spacing;
  }
  parallelForChunks(leaves, [&](std::size_t begin, std::size_t end) {
    const auto look = [&](std::int32_t i) { return nearestSquared(tree, i); };
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      measureLeaf(tree, leaf, look, spacing);
  });
  return spacing;
}

} // namespace pcl::acmap::ACMAP_DEWALL
