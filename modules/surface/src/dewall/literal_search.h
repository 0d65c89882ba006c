#pragma once

#include "apex_search.h"
#include "point_tree.h"
#include "size_constraint.h"

#include <array>
#include <optional>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A side of a triangle (a, b, opposite): plane beta passes through a and b and is
 * perpendicular to the triangle. */
struct TriangleSide {
  std::int32_t a, b, opposite;
};

/** \brief The splitting plane alpha of a call: through a point of the call's part, and
 * perpendicular to an axis. */
struct SplittingPlane {
  int axis = 0;
  std::int32_t point = 0;
};

/** \brief The point set P of [P] II-C.1: one cluster, with the searches of Fig. 6. Points
 * are indices of its own tree. */
class LiteralPoints {
public:
  /** \param[in] all the whole cloud
   * \param[in] size of the whole cloud
   * \param[in] members of the cluster, indices of \a all */
  LiteralPoints(const PointTree& all,
                const SizeConstraint& size,
                const std::vector<std::int32_t>& members);

  std::int32_t
  size() const
  {
    return own_.size();
  }

  /** \brief Index of a point in the tree of the whole cloud. */
  std::int32_t
  indexInAll(std::int32_t i) const
  {
    return own_.source(i);
  }

  float
  coordinate(std::int32_t i, int axis) const
  {
    return own_.coordinates(axis)[i];
  }

  /** \brief Does point i come before j along an axis? Points at the same place are in the
   * order of the input. */
  bool
  comesBefore(std::int32_t i, std::int32_t j, int axis) const
  {
    const float at_i = coordinate(i, axis), at_j = coordinate(j, axis);
    return at_i < at_j || (at_i == at_j && source(i) < source(j));
  }

  /** \brief InHalfSpaceL of a point; the point of the plane itself is on the right. */
  bool
  isLeft(std::int32_t i, const SplittingPlane& alpha) const
  {
    return comesBefore(i, alpha.point, alpha.axis);
  }

  /** \brief FindFirstTriangle: p1 is the nearest point to alpha, p2 the nearest to p1 on
   * the other side, p3 the one with the smallest circumcircle. If that triangle is
   * refused, the next nearest point is p1: what follows then is left open. */
  std::optional<std::array<std::int32_t, 3>>
  findFirstTriangle(const SplittingPlane& alpha) const;

  /** \brief FindTriangle: the point beyond plane beta with the smallest circumcircle; -1
   * if there is none or if its triangle is refused. */
  std::int32_t
  findTriangle(const TriangleSide& side) const;

private:
  /** Index in the view, which decides all ties. */
  std::int32_t
  source(std::int32_t i) const
  {
    return all_.source(own_.source(i));
  }

  double
  longest(std::int32_t i) const
  {
    return size_.longest(own_.source(i));
  }

  bool
  isNearEnough(std::int32_t i, std::int32_t j) const;

  std::int32_t
  nearestAcross(std::int32_t p1, const SplittingPlane& alpha) const;

  /** \brief Does p3 complete the triangle over a and b: is it near enough from both, and
   * is no point of the cluster P inside the sphere? */
  bool
  isAccepted(std::int32_t a, std::int32_t b, std::int32_t p3) const;

  std::int32_t
  acceptedThird(const SideFrame& frame) const;

  std::int32_t
  smallestCircle(const SideFrame& frame, double reach) const;

  std::int32_t
  smallestCircleOneByOne(const SideFrame& frame, double reach) const;

  const PointTree& all_;
  const SizeConstraint& size_;
  const PointTree own_; ///< its source is the index in the tree of the whole cloud
};

} // namespace pcl::acmap::ACMAP_DEWALL
