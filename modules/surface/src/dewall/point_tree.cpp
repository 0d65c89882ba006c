#include "point_tree.h"

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
  const auto count = static_cast<std::int32_t>(points.size());
  nodes_.reserve(points.size() / (leaf_capacity / 4) + 1);
  build(points, 0, count);
  source_.resize(points.size());
  for (auto& axis : coordinates_)
    axis.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      coordinates_[axis][i] = points[i].position[axis];
    source_[i] = points[i].source;
  }
}

std::int32_t
PointTree::build(std::vector<SourcePoint>& points, std::int32_t begin, std::int32_t end)
{
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.begin = begin;
  node.end = end;
  fitBox(node, points);
  // The order is total, so that a node's points do not depend on the standard library.
  if (node.size() <= leaf_capacity) {
    std::sort(
        points.begin() + begin,
        points.begin() + end,
        [](const SourcePoint& a, const SourcePoint& b) { return a.source < b.source; });
  }
  else {
    const std::size_t axis = widestAxis(node);
    const std::int32_t middle = begin + (end - begin) / 2;
    std::nth_element(points.begin() + begin,
                     points.begin() + middle,
                     points.begin() + end,
                     [axis](const SourcePoint& a, const SourcePoint& b) {
                       return a.position[axis] != b.position[axis]
                                  ? a.position[axis] < b.position[axis]
                                  : a.source < b.source;
                     });
    node.axis = static_cast<std::int32_t>(axis);
    node.left = build(points, begin, middle);
    node.right = build(points, middle, end);
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

} // namespace pcl::acmap::dewall
