#include "point_tree.h"

#include <limits>

namespace pcl::acmap::dewall {

namespace {

void
fitBox(PointTree::Node& node, const std::vector<SourcePoint>& points)
{
  node.low = node.high = points[static_cast<std::size_t>(node.begin)].position;
  for (std::int32_t i = node.begin; i < node.end; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float value = points[static_cast<std::size_t>(i)].position[axis];
      node.low[axis] = std::min(node.low[axis], value);
      node.high[axis] = std::max(node.high[axis], value);
    }
}

std::size_t
widestAxis(const PointTree::Node& node)
{
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (node.high[axis] - node.low[axis] > node.high[widest] - node.low[widest])
      widest = axis;
  return widest;
}

} // namespace

PointTree::PointTree(std::vector<SourcePoint> points)
{
  if (points.empty())
    return;
  nodes_.reserve(points.size() / (leaf_capacity / 4) + 1);
  leaf_of_.resize(points.size());
  Node root;
  root.end = static_cast<std::int32_t>(points.size());
  root.cell_low.fill(-std::numeric_limits<float>::infinity());
  root.cell_high.fill(std::numeric_limits<float>::infinity());
  build(points, root);
  source_.resize(points.size());
  for (auto& axis : coordinates_)
    axis.resize(points.size() + leaf_capacity);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      coordinates_[axis][i] = points[i].position[axis];
    source_[i] = points[i].source;
  }
}

std::int32_t
PointTree::build(std::vector<SourcePoint>& points, Node node)
{
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  fitBox(node, points);
  // The order is total, so that a node's points do not depend on the standard library.
  if (node.size() <= leaf_capacity) {
    std::sort(
        points.begin() + node.begin,
        points.begin() + node.end,
        [](const SourcePoint& a, const SourcePoint& b) { return a.source < b.source; });
    std::fill(leaf_of_.begin() + node.begin, leaf_of_.begin() + node.end, index);
  }
  else {
    const std::size_t axis = widestAxis(node);
    const auto middle = points.begin() + node.begin + node.size() / 2;
    std::nth_element(points.begin() + node.begin,
                     middle,
                     points.begin() + node.end,
                     [axis](const SourcePoint& a, const SourcePoint& b) {
                       return a.position[axis] != b.position[axis]
                                  ? a.position[axis] < b.position[axis]
                                  : a.source < b.source;
                     });
    node.axis = static_cast<std::int32_t>(axis);
    Node left = node, right = node;
    left.parent = right.parent = index;
    left.end = right.begin = node.begin + node.size() / 2;
    // Points on the plane stand in both halves: it belongs to neither cell's inside.
    left.cell_high[axis] = right.cell_low[axis] = middle->position[axis];
    node.left = build(points, left);
    node.right = build(points, right);
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

} // namespace pcl::acmap::dewall
