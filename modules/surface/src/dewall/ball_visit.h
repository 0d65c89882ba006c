#pragma once

#include "point_tree.h"
#include "tree_walk.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Visits the leaves that intersect a ball, near ones first.
 *
 * \param[in] start a point near the centre, where the traversal begins
 * \param[in] centre of the ball
 * \param[in] radius it is read again after each visit, which may shrink it; a negative
 * value ends the traversal
 * \param[in] keep_members (level, group) returns a bit for each member of a group that
 * has to be visited
 * \param[in] visit_leaf (leaf, index of its first point, index after its last) */
template <typename Keep, typename Visit>
void
visitBall(const PointTree& tree,
          std::int32_t start,
          const Eigen::Vector3d& centre,
          const double& radius,
          const Keep& keep_members,
          const Visit& visit_leaf)
{
  struct Visitor {
    const PointTree& tree;
    const double& radius;
    const Keep& keep;
    const Visit& call;
    Ball ball;

    void
    visit(std::int32_t leaf)
    {
      call(leaf, tree.firstOfLeaf(leaf), tree.firstOfLeaf(leaf + 1));
      ball.radius = static_cast<float>(radius);
    }
  };
  const Eigen::Vector3f rounded = centre.cast<float>();
  Visitor visitor{tree,
                  radius,
                  keep_members,
                  visit_leaf,
                  ballAt(rounded.data(), static_cast<float>(radius))};
  walkTree(tree.cells(), visitor, tree.leafOf(start));
}

/** \brief Visits all leaves that intersect a ball. */
template <typename Visit>
void
visitBall(const PointTree& tree,
          std::int32_t start,
          const Eigen::Vector3d& centre,
          const double& radius,
          const Visit& visit)
{
  visitBall(
      tree, start, centre, radius, [](int, std::int32_t) { return 0xffu; }, visit);
}

} // namespace pcl::acmap::ACMAP_DEWALL
