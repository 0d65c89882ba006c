#pragma once

#include "tree_cells.h"

#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A point and its index in the view. */
struct SourcePoint {
  std::array<float, 3> position;
  std::int32_t source;
};

using SourcePoints = LargeVector<SourcePoint>;

/** \brief The splitting planes of the divide step, and the cells of all searches.
 *
 * This is a complete tree of median splits along the widest axis. The points are in the
 * order of its leaves, so that a node has a contiguous range of indices, a splitting
 * plane alpha separates two ranges, and a leaf (8 to 16 points in a tight box) is a
 * cell that adapts to any density and extent. Only planes and boxes of the nodes are
 * stored: their ranges follow from the number of points. */
class PointTree {
public:
  /** \brief Node \a index of the 2^depth nodes at a depth. */
  struct Node {
    int depth = 0;
    std::int32_t index = 0;

    Node
    left() const
    {
      return {depth + 1, 2 * index};
    }

    Node
    right() const
    {
      return {depth + 1, 2 * index + 1};
    }
  };

  /** \brief The splitting plane alpha of an inner node. */
  struct Plane {
    float offset;
    std::uint8_t axis;
  };

  static constexpr std::int32_t leaf_capacity = TreeCells::leaf_capacity;

  /** \param[in] points finite and pairwise distinct, in any order */
  explicit PointTree(SourcePoints points);

  PointTree(const PointTree&) = delete;
  PointTree&
  operator=(const PointTree&) = delete;

  std::int32_t
  size() const
  {
    return static_cast<std::int32_t>(source_.size());
  }

  const TreeCells&
  cells() const
  {
    return cells_;
  }

  /** \brief First point of a node; its last one precedes the first one of the next
   * node. */
  std::int32_t
  firstOf(const Node& node) const
  {
    return static_cast<std::int32_t>((node.index * cells_.points) >> node.depth);
  }

  std::int32_t
  endOf(const Node& node) const
  {
    return firstOf({node.depth, node.index + 1});
  }

  bool
  isLeaf(const Node& node) const
  {
    return node.depth == cells_.depth;
  }

  const Plane&
  planeOf(const Node& node) const
  {
    return planes_[(std::size_t{1} << node.depth) +
                   static_cast<std::size_t>(node.index)];
  }

  std::int32_t
  leafCount() const
  {
    return std::int32_t{1} << cells_.depth;
  }

  /** \brief First point of a leaf; for the number of leaves it is the number of
   * points. */
  std::int32_t
  firstOfLeaf(std::int32_t leaf) const
  {
    return ACMAP_DEWALL::firstOfLeaf(cells_, leaf);
  }

  /** \brief The leaf that contains tree point \a i. */
  std::int32_t
  leafOf(std::int32_t i) const
  {
    auto leaf = static_cast<std::int32_t>((i + 0.5) * leaves_a_point_);
    leaf -= i < firstOfLeaf(leaf);
    return leaf + (i >= firstOfLeaf(leaf + 1));
  }

  /** \brief Coordinates of all points along an axis, in tree order; they are followed
   * by zeros for the capacity of a leaf. */
  const float*
  coordinates(int axis) const
  {
    return cells_.coordinates[axis];
  }

  Eigen::Vector3d
  position(std::int32_t i) const
  {
    return {coordinates(0)[i], coordinates(1)[i], coordinates(2)[i]};
  }

  /** \brief Index of tree point \a i in the view. */
  std::int32_t
  source(std::int32_t i) const
  {
    return source_[static_cast<std::size_t>(i)];
  }

  /** \brief Tight box of a leaf. */
  Eigen::AlignedBox3f
  boxOfLeaf(std::int32_t leaf) const;

private:
  struct Builder;

  void
  takePoints(const SourcePoints& points);

  void
  makeGroups();

  void
  makeCells(int level);

  TreeCells cells_;
  double leaves_a_point_ = 0;
  std::array<LargeVector<float>, 3> coordinates_;
  LargeVector<std::int32_t> source_;
  LargeVector<Plane> planes_; ///< planes at depth d begin at 2^d
  std::array<LargeVector<SiblingBoxes>, TreeCells::max_levels + 1> boxes_;
  std::array<LargeVector<CellBox>, TreeCells::max_levels + 1> cell_boxes_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
