// Traversal of a tree's groups of eight, near ones first.
#pragma once

#include "lanes.h"
#include "tree_cells.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** A ball that may shrink during the traversal; a negative radius ends it. */
struct Ball {
  float centre[3];
  float slack; ///< maximum rounding error of the centre
  float radius;

  ACMAP_INLINE float
  reach() const
  {
    return (radius + slack) * (1 + 1e-6f);
  }
};

ACMAP_INLINE Ball
ballAt(const float* centre, float radius)
{
  Ball ball{{centre[0], centre[1], centre[2]}, 0, radius};
  for (int axis = 0; axis < 3; ++axis) {
    const float size = centre[axis] < 0 ? -centre[axis] : centre[axis];
    ball.slack = size > ball.slack ? size : ball.slack;
  }
  ball.slack *= 0x1p-21f;
  return ball;
}

ACMAP_INLINE bool
isInside(const Ball& ball, const CellBox& cell)
{
  const float reach = ball.reach();
  for (int axis = 0; axis < 3; ++axis)
    if (!(ball.centre[axis] - reach > cell.low[axis] && // NaN is not inside
          ball.centre[axis] + reach < cell.high[axis]))
      return false;
  return true;
}

ACMAP_INLINE Lanes
squaredDistances(const SiblingBoxes& boxes, const Ball& ball)
{
  Lanes sum = allLanes(0);
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes centre = allLanes(ball.centre[axis]);
    const Lanes outside = maxLanes(maxLanes(loadLanes(boxes.low[axis]) - centre,
                                            centre - loadLanes(boxes.high[axis])),
                                   allLanes(0));
    sum += outside * outside;
  }
  return sum;
}

/** Returns a bit for each member of a group that may have points in a half-space.
 * \param[in] origin of the half-space
 * \param[in] inward its unit normal */
ACMAP_INLINE unsigned
membersBeyond(const SiblingBoxes& boxes, const float* origin, const float* inward)
{
  Lanes maximum = allLanes(0), size = allLanes(0);
  for (int axis = 0; axis < 3; ++axis) {
    const float w = inward[axis];
    const Lanes far = loadLanes(w > 0 ? boxes.high[axis] : boxes.low[axis]);
    const Lanes forward = (far - allLanes(origin[axis])) * allLanes(w);
    maximum += forward;
    size += maxLanes(forward, -forward);
  }
  return bitsOf(maximum >= allLanes(-1e-6f) * size);
}

/** Returns a bit for each member of a group of a level; only the highest level may have
 * fewer than eight. The masked lanes would be reached by an infinite ball. */
ACMAP_INLINE unsigned
membersOf(const TreeCells& tree, int level)
{
  const int depth = tree.depth - 3 * (level - 1);
  return depth < 3 ? (1u << (1u << depth)) - 1 : 0xffu;
}

/** Visits the members of a group and their descendants, except member \a without (-1:
 * none is excluded). The visitor has a ball; keep (level, group) returns a bit per
 * member; visit (leaf) may shrink the ball. */
template <typename Visitor>
void
walkGroup(
    const TreeCells& tree, Visitor& visitor, int level, std::int32_t group, int without)
{
  const SiblingBoxes& boxes = tree.boxes[level][group];
  const Lanes squared = squaredDistances(boxes, visitor.ball);
  const float reach = visitor.ball.reach();
  unsigned left = bitsOf(squared <= allLanes(reach * reach)) & membersOf(tree, level) &
                  visitor.keep(level, group);
  if (without >= 0)
    left &= ~(1u << without);
  while (left) {
    const unsigned nearest =
        left & (left - 1) ? smallestLane(squared, left) : lowestBit(left);
    left &= ~(1u << nearest);
    const float now = visitor.ball.reach();
    if (visitor.ball.radius < 0 || squared[nearest] > now * now)
      return;
    const std::int32_t member = 8 * group + static_cast<std::int32_t>(nearest);
    if (level == 1)
      visitor.visit(member);
    else
      walkGroup(tree, visitor, level - 1, member, -1);
  }
}

/** Ascends from a leaf until the cell of the group contains the ball. */
template <typename Visitor>
void
walkTree(const TreeCells& tree, Visitor& visitor, std::int32_t leaf)
{
  int from = -1;
  for (int level = 1; level <= tree.levels; ++level) {
    const std::int32_t group = leaf >> (3 * level);
    walkGroup(tree, visitor, level, group, from);
    if (visitor.ball.radius < 0 || isInside(visitor.ball, tree.cells[level][group]))
      return;
    from = static_cast<int>(group & 7);
  }
}

} // namespace pcl::acmap::ACMAP_DEWALL
