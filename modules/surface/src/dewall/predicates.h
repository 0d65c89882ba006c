#pragma once

#include "variant.h"

#include <Eigen/Geometry>

#include <cstdint>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief The smallest sphere through the corners of a triangle; its centre is in the
 * plane of the triangle. */
struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

/** \brief Points within (1 - this) radius of the centre are inside a sphere. */
inline constexpr double sphere_tolerance = 1e-6;

/** \brief Cosine of the turn between adjacent triangles (0 degrees is flat) beyond
 * which a triangle is built only if there is no other (60 degrees). */
inline constexpr double cos_gentle_turn = 0.5;

/** \brief Cosine of the largest permitted turn at the edges that a new triangle closes,
 * 127 degrees: creases of 90 degrees and noisy surfaces have to be closed, but not
 * folds. At the edge over which the triangle is built, plane beta limits the turn to 90
 * degrees. */
inline constexpr double cos_largest_turn = -0.6;

/** \brief Height of a triangle relative to its longest edge below which its normal is
 * determined by noise, so that it is built only if there is no other. */
inline constexpr double min_plumpness = 0.25;

/** \brief Sine below which three corners are considered collinear. */
inline constexpr double min_sine = 1e-10;

/** \brief Are the corners on a line, within the precision of their coordinates? */
inline bool
isDegenerate(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a, w = c - b;
  const double longest =
      std::max(u.squaredNorm(), std::max(v.squaredNorm(), w.squaredNorm()));
  return u.cross(v).squaredNorm() <= min_sine * min_sine * longest * longest;
}

inline Sphere
smallestSphere(const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a, n = u.cross(v);
  const Eigen::Vector3d to_centre =
      (v.squaredNorm() * n.cross(u) + u.squaredNorm() * v.cross(n)) /
      (2 * n.squaredNorm());
  return {a + to_centre, to_centre.norm()};
}

/** \brief Component of p - a perpendicular to the line a b. For the corner of a needle,
 * the rounding error of the first subtraction is larger than this component, so it is
 * repeated. */
inline Eigen::Vector3d
perpendicular(const Eigen::Vector3d& a,
              const Eigen::Vector3d& b,
              const Eigen::Vector3d& p)
{
  const Eigen::Vector3d u = b - a, v = p - a;
  const Eigen::Vector3d part = v - u * (v.dot(u) / u.squaredNorm());
  if (part.squaredNorm() > 1e-8 * v.squaredNorm())
    return part;
  return part - u * (part.dot(u) / u.squaredNorm());
}

/** \brief Cosine of the turn at edge a b from triangle (a, b, o) to (a, b, p): positive
 * if p is in the valid half-space beyond plane beta, 1 if both triangles are
 * coplanar. */
inline double
cosineOfTurn(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& o,
             const Eigen::Vector3d& p)
{
  const Eigen::Vector3d to_o = perpendicular(a, b, o), to_p = perpendicular(a, b, p);
  return -to_o.dot(to_p) / (to_o.norm() * to_p.norm());
}

/** \brief A candidate for the apex over edge a b, relative to a. */
struct Apex {
  std::int32_t index = -1;
  Eigen::Vector3d from_a; ///< p - a, exact for floats that are close
  double dot = 0;         ///< (a - p) . (b - p)
  double cross = 0;       ///< |(b - a) x (p - a)|
};

Apex
makeApex(std::int32_t index, const Eigen::Vector3d& u, const Eigen::Vector3d& v);

/** \brief Is p Delaunay-nearer to the edge than q, i.e. is the angle a p b larger?
 *
 * Candidates are ordered by the signed Delaunay distance (|ab| / 2) cot (angle apb).
 * The comparison is done in double precision if an error bound permits, otherwise in
 * exact arithmetic. Exact ties (cocircular points) are resolved as if the point with
 * the lowest index were lowered from the paraboloid: the diagonal of four cocircular
 * points starts at their lowest index, so the triangulation is the same from whichever
 * edge it is grown. The result is a strict weak order for any candidates, including
 * those on circles of the same size around the edge.
 * \param[in] a, b indices of the ends of the edge
 * \param[in] u b - a */
bool
isNearerApex(const Apex& p,
             const Apex& q,
             std::int32_t a,
             std::int32_t b,
             const Eigen::Vector3d& u);

/** \brief Is the circle through a, b and p smaller than the one through a, b and q?
 *
 * Its radius is |ab| / (2 sin (angle apb)), so it is the smallest where the angle is
 * closest to 90 degrees. Decided as \ref isNearerApex, which also decides between
 * circles of the same size. The parameters are those of \ref isNearerApex. */
bool
hasSmallerCircle(const Apex& p,
                 const Apex& q,
                 std::int32_t a,
                 std::int32_t b,
                 const Eigen::Vector3d& u);

} // namespace pcl::acmap::ACMAP_DEWALL
