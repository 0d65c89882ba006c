#pragma once

#include "growing_mesh.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A contiguous range of tree points; for a wall, also the first one beyond the
 * splitting plane. */
struct Range {
  std::int32_t begin, end;
  std::int32_t middle;               ///< begin in a leaf: all edges belong to it
  std::int32_t first_leaf, end_leaf; ///< leaves of the tree

  Range(const PointTree& tree, const PointTree::Node& node, bool is_wall)
  : begin(tree.firstOf(node))
  , end(tree.endOf(node))
  , middle(is_wall ? tree.firstOf(node.right()) : begin)
  , first_leaf(firstLeaf(tree, node))
  , end_leaf(firstLeaf(tree, {node.depth, node.index + 1}))
  {}

  bool
  contains(std::int32_t i) const
  {
    return begin <= i && i < end;
  }

  bool
  isWhole(const PointTree& tree) const
  {
    return end - begin == tree.size();
  }

  /** \brief Is this edge in L_alpha, the list of edges that alpha cuts (Fig. 6)? */
  bool
  isCut(const Side& side) const
  {
    return middle == begin || (side.a < middle) != (side.b < middle);
  }

private:
  static std::int32_t
  firstLeaf(const PointTree& tree, const PointTree::Node& node)
  {
    return node.index << (tree.cells().depth - node.depth);
  }
};

} // namespace pcl::acmap::ACMAP_DEWALL
