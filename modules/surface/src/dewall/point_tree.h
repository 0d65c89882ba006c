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
    std::array<float, 3> low, high;
    std::int32_t begin = 0, end = 0;
    std::int32_t left = -1, right = -1;
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
  nodeCount() const
  {
    return static_cast<std::int32_t>(nodes_.size());
  }

  /** \brief Coordinates along an axis, of all points in tree order. */
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

  /** \brief Visits the leaves that a ball touches, the nearest first.
   *
   * \param[in] centre of the ball
   * \param[in] radius read anew before each step, so that visit () may shrink it;
   * negative ends the walk \param[in] keep (node) false prunes a subtree \param[in]
   * visit (leaf node) */
  template <typename Keep, typename Visit>
  void
  visitBall(const Eigen::Vector3d& centre,
            const double& radius,
            const Keep& keep,
            const Visit& visit) const;

private:
  std::int32_t
  build(std::vector<SourcePoint>& points, std::int32_t begin, std::int32_t end);

  std::vector<Node> nodes_;
  std::array<std::vector<float>, 3> coordinates_;
  std::vector<std::int32_t> source_;
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

template <typename Keep, typename Visit>
void
PointTree::visitBall(const Eigen::Vector3d& centre,
                     const double& radius,
                     const Keep& keep,
                     const Visit& visit) const
{
  struct Entry {
    std::int32_t node;
    float squared_distance;
  };
  const Eigen::Vector3f c = centre.cast<float>();
  // Rounding the centre may move it by this much: a box must not be missed for that.
  const double slack = static_cast<double>(c.cwiseAbs().maxCoeff()) * 0x1p-22;
  const auto touches = [&](float squared_distance) {
    const double reach = (radius + slack) * (1 + 1e-6);
    return radius >= 0 && static_cast<double>(squared_distance) <= reach * reach;
  };
  std::array<Entry, 64> stack; // the tree is balanced: its depth is below 32
  std::size_t top = 0;
  stack[top++] = {0, squaredDistanceToBox(nodes_[0], c)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (!touches(entry.squared_distance))
      continue;
    const Node& current = node(entry.node);
    if (!keep(current))
      continue;
    if (current.isLeaf()) {
      visit(current);
      continue;
    }
    Entry near{current.left, squaredDistanceToBox(node(current.left), c)};
    Entry far{current.right, squaredDistanceToBox(node(current.right), c)};
    if (far.squared_distance < near.squared_distance)
      std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
}

} // namespace pcl::acmap::dewall
