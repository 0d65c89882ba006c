#include "predicates.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::dewall {

namespace {

using Integer = boost::multiprecision::cpp_int;
using IntegerVector = std::array<Integer, 3>;

/** \brief Exponent e such that all coordinates are integers times 2^e. */
int
commonExponent(std::initializer_list<const Eigen::Vector3d*> vectors)
{
  int least = 1 << 20;
  for (const Eigen::Vector3d* v : vectors)
    for (int axis = 0; axis < 3; ++axis)
      if ((*v)[axis] != 0) {
        int exponent = 0;
        std::frexp((*v)[axis], &exponent);
        least = std::min(least, exponent - 53);
      }
  return least;
}

IntegerVector
scaled(const Eigen::Vector3d& v, int exponent)
{
  IntegerVector result;
  for (int axis = 0; axis < 3; ++axis) {
    if (v[axis] == 0)
      continue;
    int own = 0;
    const double mantissa = std::frexp(v[axis], &own);
    result[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::ldexp(mantissa, 53));
    result[static_cast<std::size_t>(axis)] <<= own - 53 - exponent;
  }
  return result;
}

Integer
dot(const IntegerVector& a, const IntegerVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** \brief dot |dot|, to be compared across candidates after division by cross^2. */
Integer
signedSquare(const Integer& value)
{
  return value < 0 ? Integer(-value * value) : Integer(value * value);
}

/** \brief Sign of (p.dot / p.cross - q.dot / q.cross), exact. */
int
compareExactly(const Apex& p, const Apex& q, const Eigen::Vector3d& u)
{
  const int exponent = commonExponent({&u, &p.from_a, &q.from_a});
  const IntegerVector iu = scaled(u, exponent);
  const auto parts = [&](const Apex& apex) {
    const IntegerVector v = scaled(apex.from_a, exponent);
    const Integer uv = dot(iu, v), vv = dot(v, v);
    return std::pair<Integer, Integer>(signedSquare(vv - uv),
                                       dot(iu, iu) * vv - uv * uv);
  };
  const auto [dot_p, cross_p] = parts(p);
  const auto [dot_q, cross_q] = parts(q);
  const Integer left = dot_p * cross_q, right = dot_q * cross_p;
  return left < right ? -1 : (right < left ? 1 : 0);
}

/** \brief Which of two candidates on one circle through a and b the pulled
 * triangulation puts over side a b. */
bool
winsTie(const Apex& p,
        const Apex& q,
        std::int32_t a,
        std::int32_t b,
        const Eigen::Vector3d& u)
{
  const Eigen::Vector3d turn = (p.from_a - u).cross(q.from_a - u);
  const bool p_follows_b = turn.dot(u.cross(p.from_a)) > 0; // round the circle: a b p q
  const std::int32_t lowest = std::min(std::min(a, b), std::min(p.index, q.index));
  return lowest == p.index || lowest == (p_follows_b ? a : b);
}

} // namespace

Apex
makeApex(std::int32_t index, const Eigen::Vector3d& u, const Eigen::Vector3d& v)
{
  return {index, v, v.dot(v - u), u.cross(v).norm()};
}

bool
isNearerApex(const Apex& p,
             const Apex& q,
             std::int32_t a,
             std::int32_t b,
             const Eigen::Vector3d& u)
{
  const double left = p.dot * q.cross, right = q.dot * p.cross;
  const double length_p = p.from_a.norm(), length_q = q.from_a.norm();
  const double bound =
      1e-14 * u.norm() * length_p * length_q * (2 * u.norm() + length_p + length_q);
  if (left < right - bound)
    return true;
  if (left > right + bound)
    return false;
  const int sign = compareExactly(p, q, u);
  return sign != 0 ? sign < 0 : winsTie(p, q, a, b, u);
}

} // namespace pcl::acmap::dewall
