#include "size_constraint.h"

#include "spacing.h"

namespace pcl::acmap::dewall {

namespace {

/** \brief Edges reach this many times the distance to the eighth neighbour. */
constexpr double reach = 2.5;

} // namespace

SizeConstraint::SizeConstraint(const PointTree& tree, double maximum_edge_length)
: tree_(tree)
, longest_(static_cast<std::size_t>(tree.nodeCount()), maximum_edge_length)
, least_(maximum_edge_length)
, largest_(maximum_edge_length)
{}

SizeConstraint::SizeConstraint(const PointTree& tree, const Spacing& spacing)
: tree_(tree)
, longest_(static_cast<std::size_t>(tree.nodeCount()))
{
  for (std::size_t l = 0; l < spacing.leaves.size(); ++l)
    longest_[static_cast<std::size_t>(spacing.leaves[l])] = reach * spacing.eighth[l];
  const auto [least, largest] =
      std::minmax_element(spacing.eighth.begin(), spacing.eighth.end());
  least_ = reach * *least;
  largest_ = reach * *largest;
}

} // namespace pcl::acmap::dewall
