#include "size_constraint.h"

#include "nearest.h"

#include <pcl/core/parallel.h>

namespace pcl::acmap::dewall {

namespace {

/** \brief Edges reach this many times the distance to the eighth neighbour, which on a
 * square grid is 1.41 spacings, on random points 1.6. */
constexpr double reach = 2.5;
constexpr std::size_t neighbour = 8;

std::vector<std::int32_t>
leaves(const PointTree& tree)
{
  std::vector<std::int32_t> result;
  for (std::int32_t n = 0; n < tree.nodeCount(); ++n)
    if (tree.node(n).isLeaf())
      result.push_back(n);
  return result;
}

/** \brief Distance to the k-th neighbour for each leaf, the lesser one of two of its
 * points, so that one outlier in a leaf does not speak for the others. */
std::vector<double>
distances(const PointTree& tree, const std::vector<std::int32_t>& leaves, std::size_t k)
{
  std::vector<double> result(leaves.size());
  parallelForChunks(leaves.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l) {
      const PointTree::Node& leaf = tree.node(leaves[l]);
      result[l] =
          std::min(distanceToNeighbour(tree, leaf.begin + leaf.size() / 4, k),
                   distanceToNeighbour(tree, leaf.end - 1 - leaf.size() / 4, k));
    }
  });
  return result;
}

} // namespace

SizeConstraint::SizeConstraint(const PointTree& tree, double maximum_edge_length)
: tree_(tree)
, longest_(static_cast<std::size_t>(tree.nodeCount()), maximum_edge_length)
, least_(maximum_edge_length)
, largest_(maximum_edge_length)
{}

SizeConstraint::SizeConstraint(const PointTree& tree)
: tree_(tree)
, longest_(static_cast<std::size_t>(tree.nodeCount()))
{
  const std::vector<std::int32_t> all = leaves(tree);
  const std::vector<double> spacing = distances(tree, all, neighbour);
  for (std::size_t l = 0; l < all.size(); ++l)
    longest_[static_cast<std::size_t>(all[l])] = reach * spacing[l];
  const auto [least, largest] = std::minmax_element(spacing.begin(), spacing.end());
  least_ = reach * *least;
  largest_ = reach * *largest;
}

double
medianSpacing(const PointTree& tree)
{
  if (tree.size() < 2)
    return 0;
  std::vector<double> nearest = distances(tree, leaves(tree), 1);
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

} // namespace pcl::acmap::dewall
