#pragma once

#include "point_tree.h"

#include <algorithm>

namespace pcl::acmap::ACMAP_DEWALL {

struct Spacing;

/** \brief The paper's triangle size constraint, as a predicate for edges.
 *
 * Each leaf of the tree has a maximum edge length; an edge has to satisfy the limits of
 * both ends. */
class SizeConstraint {
public:
  /** \brief The same length everywhere. */
  SizeConstraint(const PointTree& tree, double maximum_edge_length);

  /** \brief From the spacing around each leaf. */
  SizeConstraint(const PointTree& tree, const Spacing& spacing);

  /** \brief Maximum edge length at tree point \a i, metres. */
  double
  longest(std::int32_t i) const
  {
    return longestInLeaf(tree_.leafOf(i));
  }

  /** \brief Maximum edge length at the points of a leaf, metres. */
  double
  longestInLeaf(std::int32_t leaf) const
  {
    return longest_[static_cast<std::size_t>(leaf)];
  }

  /** \brief Maximum edge length of all leaves, metres. */
  const float*
  longestOfLeaves() const
  {
    return longest_.data();
  }

  bool
  allows(std::int32_t i, std::int32_t j, double squared_length) const
  {
    const double limit = std::min(longest(i), longest(j));
    return squared_length <= limit * limit;
  }

  double
  minimum() const
  {
    return minimum_;
  }

  double
  largest() const
  {
    return largest_;
  }

private:
  const PointTree& tree_;
  LargeVector<float> longest_;
  double minimum_ = 0, largest_ = 0;
};

} // namespace pcl::acmap::ACMAP_DEWALL
