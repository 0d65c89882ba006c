#pragma once

#include <Eigen/Geometry>

#include <cstdint>

namespace pcl::acmap::dewall {

/** \brief Sphere through the corners of a triangle, centred in its plane (the
 * smallest). */
struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

/** \brief Points nearer to the sphere's centre than (1 - this) radius are inside. */
inline constexpr double sphere_tolerance = 1e-6;

/** \brief Cosine of the turn from a triangle to its neighbour (0 degrees is flat)
 * beyond which it is built only when nothing else is left (60 degrees). */
inline constexpr double cos_gentle_turn = 0.5;

/** \brief Cosine of the largest turn at the sides a new triangle closes besides the one
 * it grew over, whose plane beta bounds the turn at 90 degrees: creases of 90 degrees
 * and noise must close, folds must not (127 degrees). */
inline constexpr double cos_largest_turn = -0.6;

/** \brief Height of a triangle over its longest edge below which noise decides where
 * its normal points, so that it is built only when nothing else is left. */
inline constexpr double least_plumpness = 0.25;

/** \brief Sine below which the three corners count as collinear. */
inline constexpr double least_sine = 1e-10;

/** \brief True when the corners lie on a line, as far as their coordinates tell. */
inline bool
isDegenerate(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a, w = c - b;
  const double longest =
      std::max(u.squaredNorm(), std::max(v.squaredNorm(), w.squaredNorm()));
  return u.cross(v).squaredNorm() <= least_sine * least_sine * longest * longest;
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

/** \brief Part of p - a at right angles to the line a b. Of a needle's corner the first
 * subtraction leaves rounding that is longer than the part itself. */
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

/** \brief Cosine of the turn at side a b from triangle (a, b, o) to (a, b, p): positive
 * when p is in the valid half-space beyond plane beta, 1 when both are in one plane. */
inline double
cosineOfTurn(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& o,
             const Eigen::Vector3d& p)
{
  const Eigen::Vector3d to_o = perpendicular(a, b, o), to_p = perpendicular(a, b, p);
  return -to_o.dot(to_p) / (to_o.norm() * to_p.norm());
}

/** \brief A candidate for the apex over side a b, seen from a. */
struct Apex {
  std::int32_t index = -1;
  Eigen::Vector3d from_a; ///< p - a, exact for neighbouring floats
  double dot = 0;         ///< (a - p) . (b - p)
  double cross = 0;       ///< |(b - a) x (p - a)|
};

Apex
makeApex(std::int32_t index, const Eigen::Vector3d& u, const Eigen::Vector3d& v);

/** \brief True when p is Delaunay-nearer to the side than q: the angle a p b is larger.
 *
 * The signed Delaunay distance orders candidates by (|ab| / 2) cot (angle apb); the
 * signs decide in double where an error bound allows, in exact arithmetic otherwise.
 * Exact ties (cocircular points) are broken as if the point of lowest index were
 * lowered onto the paraboloid: the diagonal of four cocircular points starts at their
 * lowest index, which gives one triangulation from whichever side it is grown. The order
 * is strict and weak for any candidates, also for those round the side that are on
 * circles of one size.
 * \param[in] a, b indices of the side's ends
 * \param[in] u b - a */
bool
isNearerApex(const Apex& p,
             const Apex& q,
             std::int32_t a,
             std::int32_t b,
             const Eigen::Vector3d& u);

} // namespace pcl::acmap::dewall
