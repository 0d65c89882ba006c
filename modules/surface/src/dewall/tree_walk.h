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
  const float low[4] = {
      ball.centre[0] - reach, ball.centre[1] - reach, ball.centre[2] - reach, 0};
  const float high[4] = {
      ball.centre[0] + reach, ball.centre[1] + reach, ball.centre[2] + reach, 0};
  // NaN is not inside.
  return areAllGreater(low, cell.low) && areAllGreater(cell.high, high);
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

/** Calls visit (member) for the members of a group that the ball of the visitor reaches,
 * near ones first, until the ball is closed.
 * \param[in] wanted a bit for each member */
template <typename Visitor, typename Visit>
ACMAP_INLINE void
walkMembers(const TreeCells& tree,
            Visitor& visitor,
            int level,
            std::int32_t group,
            unsigned wanted,
            const Visit& visit)
{
  const Lanes squared = squaredDistances(tree.boxes[level][group], visitor.ball);
  const float reach = visitor.ball.reach();
  // An infinite ball would reach members that the highest group does not have.
  unsigned left = bitsOf(squared <= allLanes(reach * reach)) & tree.members[level] &
                  visitor.keep(level, group) & wanted;
  while (left) {
    const unsigned nearest =
        left & (left - 1) ? smallestLane(squared, left) : lowestBit(left);
    left &= ~(1u << nearest);
    const float now = visitor.ball.reach();
    if (visitor.ball.radius < 0 || squared[nearest] > now * now)
      return;
    visit(8 * group + static_cast<std::int32_t>(nearest));
  }
}

/** Visits the leaves of a group. The visitor has a ball; keep (level, group) returns a
 * bit per member; visit (leaf) may shrink the ball. */
template <typename Visitor>
__attribute__((noinline)) void
walkLeaves(const TreeCells& tree, Visitor& visitor, std::int32_t group)
{
  walkMembers(
      tree, visitor, 1, group, 0xff, [&](std::int32_t leaf) { visitor.visit(leaf); });
}

/** Visits the wanted members of a group of level 2 or higher, and their descendants. */
template <typename Visitor>
void
walkGroup(const TreeCells& tree,
          Visitor& visitor,
          int level,
          std::int32_t group,
          unsigned wanted)
{
  walkMembers(tree, visitor, level, group, wanted, [&](std::int32_t member) {
    if (level == 2)
      walkLeaves(tree, visitor, member);
    else
      walkGroup(tree, visitor, level - 1, member, 0xff);
  });
}

/** Ascends from a leaf until the cell of the group contains the ball. */
template <typename Visitor>
void
walkTree(const TreeCells& tree, Visitor& visitor, std::int32_t leaf)
{
  std::int32_t group = leaf >> 3;
  walkLeaves(tree, visitor, group);
  for (int level = 1; level < tree.levels; ++level) {
    if (visitor.ball.radius < 0 || isInside(visitor.ball, tree.cells[level][group]))
      return;
    const unsigned from = 1u << (group & 7);
    group >>= 3;
    walkGroup(tree, visitor, level + 1, group, ~from);
  }
}

} // namespace pcl::acmap::ACMAP_DEWALL
