#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap::dewall {

/** \brief A point and its place in the view it came from. */
struct SourcePoint {
  std::array<float, 3> position;
  std::int32_t source;
};

/** \brief The splitting planes of the divide step, and the cells of all searches.
 *
 * A balanced tree of median splits along the widest axis. The points stand in the order
 * of its leaves, so that a node owns a run of indices, a splitting plane alpha
 * separates two runs, and a leaf (at most 16 points in a tight box) is a cell that
 * adapts to any density and extent. */
class PointTree {
public:
  struct Node {
    std::array<float, 3> low, high;           ///< tight box of its points
    std::array<float, 3> cell_low, cell_high; ///< its share of space between the planes
    std::int32_t begin = 0, end = 0;
    std::int32_t parent = -1, left = -1, right = -1;
    std::int32_t axis = 0; ///< of the splitting plane, where there is one

    bool
    isLeaf() const
    {
      return left < 0;
    }

    std::int32_t
    size() const
    {
      return end - begin;
    }
  };

  static constexpr std::int32_t leaf_capacity = 16;

  /** \param[in] points finite and pairwise distinct */
  explicit PointTree(std::vector<SourcePoint> points);

  std::int32_t
  size() const
  {
    return static_cast<std::int32_t>(source_.size());
  }

  const Node&
  node(std::int32_t index) const
  {
    return nodes_[static_cast<std::size_t>(index)];
  }

  std::int32_t
  numberOf(const Node& node) const
  {
    return static_cast<std::int32_t>(&node - nodes_.data());
  }

  std::int32_t
  nodeCount() const
  {
    return static_cast<std::int32_t>(nodes_.size());
  }

  /** \brief Coordinates along an axis, of all points in tree order; a leaf's length of
   * zeros follows. */
  const float*
  coordinates(int axis) const
  {
    return coordinates_[static_cast<std::size_t>(axis)].data();
  }

  Eigen::Vector3d
  position(std::int32_t i) const
  {
    return {coordinates(0)[i], coordinates(1)[i], coordinates(2)[i]};
  }

  /** \brief Place of tree point \a i in the view. */
  std::int32_t
  source(std::int32_t i) const
  {
    return source_[static_cast<std::size_t>(i)];
  }

  /** \brief The leaf that holds tree point \a i. */
  std::int32_t
  leafOf(std::int32_t i) const
  {
    return leaf_of_[static_cast<std::size_t>(i)];
  }

  /** \brief Visits the leaves that a ball touches, near ones first.
   *
   * \param[in] start a point near the centre: the walk climbs from its leaf no farther
   * than to the node whose cell holds the ball
   * \param[in] centre of the ball
   * \param[in] radius read anew before each step, so that visit () may shrink it;
   * negative ends the walk
   * \param[in] keep (node) false prunes a subtree
   * \param[in] visit (leaf node) */
  template <typename Keep, typename Visit>
  void
  visitBall(std::int32_t start,
            const Eigen::Vector3d& centre,
            const double& radius,
            const Keep& keep,
            const Visit& visit) const;

private:
  struct Ball;

  std::int32_t
  build(std::vector<SourcePoint>& points, Node node);

  template <typename Keep, typename Visit>
  void
  visitSubtree(std::int32_t top,
               const Ball& ball,
               const Keep& keep,
               const Visit& visit) const;

  std::vector<Node> nodes_;
  std::array<std::vector<float>, 3> coordinates_;
  std::vector<std::int32_t> source_;
  std::vector<std::int32_t> leaf_of_;
};

/** \brief Squared distance from a point to a node's box, in float. */
inline float
squaredDistanceToBox(const PointTree::Node& node, const Eigen::Vector3f& p)
{
  float sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const float outside =
        std::max(std::max(node.low[i] - p[axis], p[axis] - node.high[i]), 0.0f);
    sum += outside * outside;
  }
  return sum;
}

/** \brief A ball whose radius may shrink under the walk. */
struct PointTree::Ball {
  Eigen::Vector3f centre;
  double
      slack; ///< rounding the centre may move it so far: no box must be missed for that
  const double& radius;

  Ball(const Eigen::Vector3d& c, const double& r)
  : centre(c.cast<float>())
  , slack(static_cast<double>(centre.cwiseAbs().maxCoeff()) * 0x1p-22)
  , radius(r)
  {}

  bool
  touches(float squared_distance) const
  {
    const double reach = (radius + slack) * (1 + 1e-6);
    return radius >= 0 && static_cast<double>(squared_distance) <= reach * reach;
  }

  bool
  isInside(const Node& node) const
  {
    const double reach = (radius + slack) * (1 + 1e-6);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const auto c = static_cast<double>(centre[axis]);
      if (c - reach <= static_cast<double>(node.cell_low[i]) ||
          c + reach >= static_cast<double>(node.cell_high[i]))
        return false;
    }
    return true;
  }
};

template <typename Keep, typename Visit>
void
PointTree::visitBall(std::int32_t start,
                     const Eigen::Vector3d& centre,
                     const double& radius,
                     const Keep& keep,
                     const Visit& visit) const
{
  const Ball ball(centre, radius);
  std::int32_t current = leafOf(start);
  visitSubtree(current, ball, keep, visit);
  while (node(current).parent >= 0 && !ball.isInside(node(current))) {
    const Node& parent = node(node(current).parent);
    visitSubtree(
        parent.left == current ? parent.right : parent.left, ball, keep, visit);
    current = node(current).parent;
  }
}

template <typename Keep, typename Visit>
void
PointTree::visitSubtree(std::int32_t top,
                        const Ball& ball,
                        const Keep& keep,
                        const Visit& visit) const
{
  struct Entry {
    std::int32_t node;
    float squared_distance;
  };
  std::array<Entry, 64> stack; // the tree is balanced: its depth is below 32
  std::size_t size = 0;
  stack[size++] = {top, squaredDistanceToBox(node(top), ball.centre)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (!ball.touches(entry.squared_distance))
      continue;
    const Node& current = node(entry.node);
    if (!keep(current))
      continue;
    if (current.isLeaf()) {
      visit(current);
      continue;
    }
    Entry near{current.left, squaredDistanceToBox(node(current.left), ball.centre)};
    Entry far{current.right, squaredDistanceToBox(node(current.right), ball.centre)};
    if (far.squared_distance < near.squared_distance)
      std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
}

} // namespace pcl::acmap::dewall
