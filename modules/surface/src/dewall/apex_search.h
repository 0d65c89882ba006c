#pragma once

#include "point_tree.h"
#include "predicates.h"
#include "size_constraint.h"

#include "tree_search.h"

#include <cmath>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief An open edge with the data for the search of its next triangle. */
struct SideFrame {
  std::int32_t a, b;
  Eigen::Vector3d origin;  ///< position of a
  Eigen::Vector3d u;       ///< b - a
  Eigen::Vector3d outward; ///< unit, in the plane of its triangle, off it; or zero
  double half_length;
  double longest; ///< maximum edge length at both ends

  SideFrame(const PointTree& tree,
            const SizeConstraint& size,
            std::int32_t a,
            std::int32_t b,
            std::int32_t opposite);

  /** \param[in] longest_at_ends maximum edge length at both ends */
  SideFrame(const PointTree& tree,
            double longest_at_ends,
            std::int32_t a,
            std::int32_t b,
            std::int32_t opposite);

  /** \brief Two points without a triangle: there is no plane beta. */
  SideFrame(const PointTree& tree,
            double longest_at_ends,
            std::int32_t a,
            std::int32_t b);

  bool
  hasHalfSpace() const
  {
    return !outward.isZero(0);
  }
};

/** \brief Points that are skipped in a search for an apex. */
struct PassedOver {
  std::int32_t point = -1; ///< a single one, -1 for none

  /** Bits of the points of each leaf; used for the leaves from first_leaf to before
   * end_leaf. */
  const std::uint16_t* masks = nullptr;
  std::int32_t first_leaf = 0, end_leaf = 0;

  bool
  contains(const PointTree& tree, std::int32_t i) const
  {
    const std::int32_t leaf = tree.leafOf(i);
    return i == point || (leaf >= first_leaf && leaf < end_leaf &&
                          (masks[leaf] >> (i - tree.firstOfLeaf(leaf)) & 1));
  }
};

/** \brief Can a search in floats use this length as its unit? */
inline bool
isWithinFloats(double length)
{
  return length > 1e-37 && length < 1e37;
}

/** \brief Returns the query in floats for the third point over an edge, without a limit
 * of the other two edges. */
ApexQuery
apexQuery(const PointTree& tree, const SideFrame& side);

/** \brief Returns the query in floats for the apex over an edge. */
ApexQuery
apexQuery(const PointTree& tree,
          const SizeConstraint& size,
          const SideFrame& side,
          const PassedOver& passed_over);

/** \brief Returns the query in floats for points inside the smallest sphere through
 * three points. */
BallQuery
ballQuery(const PointTree& tree,
          const std::array<std::int32_t, 3>& corners,
          const Sphere& sphere);

/** \brief Is the apex in the valid half-space beyond plane beta, and does it satisfy
 * the size constraint? */
bool
isApexAllowed(const SizeConstraint& size, const SideFrame& side, const Apex& apex);

/** \brief Maximum distance of a point from the middle of an edge under the size
 * constraint. */
inline double
reachFromMiddle(const SideFrame& side)
{
  return std::sqrt(
      std::max(0.0, side.longest * side.longest - side.half_length * side.half_length));
}

/** \brief Finds the Delaunay-nearest point over an edge: the point with the largest
 * angle a p b in the valid half-space beyond plane beta, under the size constraint ([P]
 * II-C.1).
 * \return its index, -1 if there is none */
std::int32_t
findApex(const PointTree& tree,
         const SizeConstraint& size,
         const SideFrame& side,
         const PassedOver& passed_over);

/** \brief The smallest sphere through three points of the tree. */
inline Sphere
sphereOf(const PointTree& tree, const std::array<std::int32_t, 3>& corners)
{
  return smallestSphere(
      tree.position(corners[0]), tree.position(corners[1]), tree.position(corners[2]));
}

/** \brief The paper's Delaunay condition: no point is inside the smallest sphere
 * through three others, up to \ref sphere_tolerance.
 * \param[in] first_tested a point that is often inside; it must not be a corner. -1: no
 * such point */
bool
isSphereEmpty(const PointTree& tree,
              const std::array<std::int32_t, 3>& corners,
              std::int32_t first_tested = -1);

} // namespace pcl::acmap::ACMAP_DEWALL
