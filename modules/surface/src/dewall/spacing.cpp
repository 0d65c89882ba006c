#include "spacing.h"

#include "ball_visit.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

constexpr std::size_t max_neighbours = 8;

/** \brief The nearest neighbours of a point that were found so far. */
class NearestNeighbours {
public:
  NearestNeighbours(const PointTree& tree, std::int32_t i)
  : tree_(tree)
  , i_(i)
  , centre_(tree.position(i))
  {
    for (int axis = 0; axis < 3; ++axis)
      at_[axis] = tree.coordinates(axis)[i];
  }

  void
  lookAt(std::int32_t first, std::int32_t end)
  {
    for (; first < end; first += 8) {
      const unsigned points = (1u << std::min(end - first, 8)) - 1;
      for (unsigned near = bitsOf(mayBeNear(first)) & points; near; near &= near - 1)
        consider(first + static_cast<std::int32_t>(lowestBit(near)));
    }
  }

  /** \brief Points that are farther away are not needed. */
  const double&
  radius() const
  {
    return radius_;
  }

  /** \brief Squared distances, ascending; there are fewer in a small tree. */
  std::vector<double>
  squared() const
  {
    return {squared_.begin(), squared_.begin() + static_cast<std::ptrdiff_t>(count_)};
  }

private:
  /** \brief In floats, with a margin above their rounding errors. */
  LaneMask
  mayBeNear(std::int32_t first) const
  {
    Lanes squared = allLanes(0);
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes v = loadLanes(tree_.coordinates(axis) + first) - allLanes(at_[axis]);
      squared += v * v;
    }
    return squared <= allLanes(limit_);
  }

  void
  consider(std::int32_t j)
  {
    if (j == i_)
      return;
    const double squared = (tree_.position(j) - centre_).squaredNorm();
    if (count_ == max_neighbours && squared >= squared_[count_ - 1])
      return;
    std::size_t place = count_ < max_neighbours ? count_++ : count_ - 1;
    for (; place > 0 && squared_[place - 1] > squared; --place)
      squared_[place] = squared_[place - 1];
    squared_[place] = squared;
    if (count_ < max_neighbours)
      return;
    radius_ = std::sqrt(squared_[count_ - 1]);
    // Squares below the smallest normal float are not comparable.
    limit_ = static_cast<float>(squared_[count_ - 1]) * (1 + 1e-5f) +
             4 * std::numeric_limits<float>::min();
  }

  const PointTree& tree_;
  const std::int32_t i_;
  const Eigen::Vector3d centre_;
  float at_[3];
  std::array<double, max_neighbours> squared_;
  std::size_t count_ = 0;
  double radius_ = std::numeric_limits<double>::max();
  float limit_ = std::numeric_limits<float>::infinity();
};

/** \brief Squared distances to the nearest neighbours, ascending; there are fewer in a
 * small tree. */
std::vector<double>
nearestSquared(const PointTree& tree, std::int32_t i)
{
  NearestNeighbours nearest(tree, i);
  visitBall(tree,
            i,
            tree.position(i),
            nearest.radius(),
            [&](std::int32_t, std::int32_t first, std::int32_t end) {
              nearest.lookAt(first, end);
            });
  return nearest.squared();
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

/** \brief The two points of a leaf at which its spacing is measured, a quarter from either
 * end. */
std::array<std::int32_t, 2>
measuredPoints(const PointTree& tree, std::size_t leaf)
{
  const auto number = static_cast<std::int32_t>(leaf);
  const std::int32_t first = tree.firstOfLeaf(number),
                     end = tree.firstOfLeaf(number + 1);
  const std::int32_t quarter = (end - first) / 4;
  return {first + quarter, end - 1 - quarter};
}

/** \brief Measures the spacing of a leaf. */
template <typename Search>
void
measureLeaf(const PointTree& tree,
            std::size_t leaf,
            const Search& search,
            Spacing& spacing)
{
  const std::array<std::int32_t, 2> points = measuredPoints(tree, leaf);
  const auto first = search(points[0]);
  const auto second = search(points[1]);
  spacing.nearest[leaf] = std::sqrt(std::min(first.front(), second.front()));
  spacing.eighth[leaf] = std::sqrt(std::min(first.back(), second.back()));
}

} // namespace

double
Spacing::median() const
{
  LargeVector<double> sorted = nearest;
  return medianOf(sorted);
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

void
reachNextRings(const PointTree& tree,
               const RingGaps& gaps,
               double edge,
               Spacing& spacing)
{
  constexpr double gaps_of_edge = 1.5;
  for (std::size_t leaf = 0; leaf < spacing.eighth.size(); ++leaf) {
    double& eighth = spacing.eighth[leaf];
    if (edge > 0)
      eighth = edge / edge_in_eighths;
    for (const std::int32_t point : measuredPoints(tree, leaf))
      eighth = std::max(eighth,
                        gaps_of_edge * gaps.at(tree.position(point)) / edge_in_eighths);
  }
}

} // namespace pcl::acmap::ACMAP_DEWALL
