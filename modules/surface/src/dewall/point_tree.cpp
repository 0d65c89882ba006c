#include "point_tree.h"

#include <pcl/core/impl/parallel.h>

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/** \brief Halves with fewer points are divided without a task of their own. */
constexpr std::int32_t min_task = 1 << 15;

std::size_t
widestAxis(const SourcePoint* begin, const SourcePoint* end)
{
  std::array<float, 3> low = begin->position, high = low;
  for (const SourcePoint* p = begin; p < end; ++p)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p->position[axis]);
      high[axis] = std::max(high[axis], p->position[axis]);
    }
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[widest] - low[widest])
      widest = axis;
  return widest;
}

/** \brief A total order along an axis, so that the points of a node do not depend on the
 * standard library. */
struct OrderAlong {
  std::size_t axis;

  bool
  operator()(const SourcePoint& a, const SourcePoint& b) const
  {
    const float p = a.position[axis], q = b.position[axis];
    return static_cast<bool>(
        static_cast<int>(p < q) |
        (static_cast<int>(p == q) & static_cast<int>(a.source < b.source)));
  }
};

/** \brief Returns an element whose rank is close to that of \a middle, by a sample. */
SourcePoint
pivotNear(const SourcePoint* begin,
          const SourcePoint* middle,
          const SourcePoint* end,
          const OrderAlong& isBefore)
{
  constexpr std::ptrdiff_t size = 32;
  std::array<SourcePoint, size> sample;
  for (std::ptrdiff_t i = 0; i < size; ++i)
    sample[static_cast<std::size_t>(i)] = begin[(end - begin) * i / size];
  // Slightly towards the longer side, so that the shorter one contains the rank.
  const std::ptrdiff_t rank = (middle - begin) * size / (end - begin);
  const std::ptrdiff_t chosen =
      std::clamp<std::ptrdiff_t>(rank < size / 2 ? rank + 2 : rank - 2, 0, size - 1);
  std::nth_element(sample.begin(), sample.begin() + chosen, sample.end(), isBefore);
  return sample[static_cast<std::size_t>(chosen)];
}

/** \brief As std::nth_element, but the loops over many points have no branches, which
 * would be mispredicted for every second point. */
void
selectMiddle(SourcePoint* begin,
             SourcePoint* middle,
             SourcePoint* end,
             const OrderAlong& isBefore)
{
  constexpr std::ptrdiff_t few = 64;
  for (int round = 0; round < 32 && end - begin > few; ++round) {
    const SourcePoint pivot = pivotNear(begin, middle, end, isBefore);
    SourcePoint* store = begin;
    for (SourcePoint* p = begin; p < end; ++p) {
      const SourcePoint moved = *p;
      *p = *store;
      *store = moved;
      store += isBefore(moved, pivot);
    }
    if (middle < store)
      end = store;
    else
      begin = store;
  }
  std::nth_element(begin, middle, end, isBefore);
}

int
depthFor(std::size_t points)
{
  int depth = 0;
  while (((points - 1) >> depth) + 1 > PointTree::leaf_capacity)
    ++depth;
  return depth;
}

/** \brief Depth in the tree of the groups of a level. */
int
depthOfLevel(const TreeCells& cells, int level)
{
  return std::max(0, cells.depth - 3 * level);
}

SiblingBoxes
noBoxes()
{
  SiblingBoxes boxes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t lane = 0; lane < 8; ++lane) {
      boxes.low[axis][lane] = infinity;
      boxes.high[axis][lane] = -infinity;
    }
  return boxes;
}

} // namespace

/** \brief Divides the points. */
struct PointTree::Builder {
  PointTree& tree;
  SourcePoints& points;

  void
  divide(const Node& node)
  {
    SourcePoint* begin = points.data() + tree.firstOf(node);
    SourcePoint* end = points.data() + tree.endOf(node);
    if (tree.isLeaf(node)) {
      std::sort(begin, end, [](const SourcePoint& a, const SourcePoint& b) {
        return a.source < b.source;
      });
      return;
    }
    const std::size_t axis = widestAxis(begin, end);
    SourcePoint* middle = points.data() + tree.firstOf(node.right());
    selectMiddle(begin, middle, end, {axis});
    tree.planes_[(std::size_t{1} << node.depth) +
                 static_cast<std::size_t>(node.index)] = {
        middle->position[axis], static_cast<std::uint8_t>(axis)};
    if (end - begin >= min_task) {
      pollRun();
      oneapi::tbb::parallel_invoke([&] { divide(node.left()); },
                                   [&] { divide(node.right()); });
    }
    else {
      divide(node.left());
      divide(node.right());
    }
  }
};

PointTree::PointTree(SourcePoints points)
{
  if (points.empty())
    return;
  cells_.points = static_cast<std::int64_t>(points.size());
  cells_.depth = depthFor(points.size());
  leaves_a_point_ =
      static_cast<double>(leafCount()) / static_cast<double>(points.size());
  planes_.resize(static_cast<std::size_t>(leafCount()));
  Builder{*this, points}.divide({});
  takePoints(points);
  makeGroups();
}

void
PointTree::takePoints(const SourcePoints& points)
{
  source_.resize(points.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    coordinates_[axis].resize(points.size() + leaf_capacity);
    cells_.coordinates[axis] = coordinates_[axis].data();
  }
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        coordinates_[axis][i] = points[i].position[axis];
      source_[i] = points[i].source;
    }
  });
}

/** Stores the box of each group among its siblings, level by level. */
void
PointTree::makeGroups()
{
  std::int32_t members = leafCount();
  for (int level = 1; level == 1 || members > 1; ++level) {
    cells_.levels = level;
    auto& groups = boxes_[static_cast<std::size_t>(level)];
    groups.assign(static_cast<std::size_t>((members + 7) / 8), noBoxes());
    cells_.boxes[level] = groups.data();
    cells_.members[level] = members < 8 ? (1u << members) - 1 : 0xff;
    for (std::int32_t m = 0; m < members; ++m) {
      SiblingBoxes& boxes = groups[static_cast<std::size_t>(m / 8)];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        float &low = boxes.low[axis][m % 8], &high = boxes.high[axis][m % 8];
        if (level == 1)
          for (std::int32_t i = firstOfLeaf(m); i < firstOfLeaf(m + 1); ++i) {
            low = std::min(low, coordinates_[axis][static_cast<std::size_t>(i)]);
            high = std::max(high, coordinates_[axis][static_cast<std::size_t>(i)]);
          }
        else {
          const SiblingBoxes& below =
              boxes_[static_cast<std::size_t>(level - 1)][static_cast<std::size_t>(m)];
          low = *std::min_element(below.low[axis], below.low[axis] + 8);
          high = *std::max_element(below.high[axis], below.high[axis] + 8);
        }
      }
    }
    makeCells(level);
    members = (members + 7) / 8;
  }
}

/** The cell of a group is bounded by the planes of its ancestors; the nearest one on
 * each side is relevant, which is encountered first. */
void
PointTree::makeCells(int level)
{
  const int depth = depthOfLevel(cells_, level);
  auto& cells = cell_boxes_[static_cast<std::size_t>(level)];
  cells.resize(std::size_t{1} << depth);
  cells_.cells[level] = cells.data();
  for (std::size_t g = 0; g < cells.size(); ++g) {
    CellBox& cell = cells[g];
    std::fill_n(cell.low, 4, -infinity);
    std::fill_n(cell.high, 4, infinity);
    for (int d = depth; d > 0; --d) {
      const std::size_t child = g >> (depth - d);
      const Plane& plane = planeOf({d - 1, static_cast<std::int32_t>(child / 2)});
      if (child % 2 == 1 && cell.low[plane.axis] == -infinity)
        cell.low[plane.axis] = plane.offset;
      if (child % 2 == 0 && cell.high[plane.axis] == infinity)
        cell.high[plane.axis] = plane.offset;
    }
  }
}

Eigen::AlignedBox3f
PointTree::boxOfLeaf(std::int32_t leaf) const
{
  const SiblingBoxes& group = cells_.boxes[1][leaf / 8];
  Eigen::Vector3f low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = group.low[axis][leaf % 8];
    high[axis] = group.high[axis][leaf % 8];
  }
  return {low, high};
}

} // namespace pcl::acmap::ACMAP_DEWALL
