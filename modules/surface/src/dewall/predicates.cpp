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
  int minimum = 1 << 20;
  for (const Eigen::Vector3d* v : vectors)
    for (int axis = 0; axis < 3; ++axis)
      if ((*v)[axis] != 0) {
        int exponent = 0;
        std::frexp((*v)[axis], &exponent);
        minimum = std::min(minimum, exponent - 53);
      }
  return minimum;
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

Integer
signedSquare(const Integer& value)
{
  return value < 0 ? Integer(-value * value) : Integer(value * value);
}

/** \brief Exact products for the triangle of a candidate p, in powers of the unit of u
 * and v = p - a. */
struct ExactApex {
  Integer at_apex; ///< (a - p) . (b - p)
  Integer at_a;    ///< u . v
  Integer sine;    ///< |u x v|^2

  ExactApex(const IntegerVector& v, const IntegerVector& u)
  : at_a(dot(u, v))
  {
    const Integer square = dot(v, v);
    at_apex = square - at_a;
    sine = dot(u, u) * square - at_a * at_a;
  }
};

/** \brief Exact sign of the difference between the cotangents of an angle of two
 * candidates.
 * \param[in] cosine member for the vertex of the angle */
int
compareCotangents(const ExactApex& p, const ExactApex& q, Integer ExactApex::*cosine)
{
  const Integer left = signedSquare(p.*cosine) * q.sine;
  const Integer right = signedSquare(q.*cosine) * p.sine;
  return left < right ? -1 : (right < left ? 1 : 0);
}

/** \brief Decides between two candidates on one circle through a and b: returns true if
 * p is the apex over edge a b in the pulled triangulation. Candidates on several
 * circles of the same size around the edge are compared by their positions on these
 * circles, so that all candidates have one order. */
bool
winsTie(std::int32_t p,
        std::int32_t q,
        std::int32_t a,
        std::int32_t b,
        const std::array<ExactApex, 2>& exact)
{
  if (std::min(p, q) < std::min(a, b))
    return p < q;
  // The order on the circle is a b p q if the angle b a p is the smaller one.
  const int p_follows_b = compareCotangents(exact[0], exact[1], &ExactApex::at_a);
  return p_follows_b != 0 ? (p_follows_b > 0) == (a < b) : p < q;
}

std::array<ExactApex, 2>
exactApexes(const Apex& p, const Apex& q, const Eigen::Vector3d& u)
{
  const int exponent = commonExponent({&u, &p.from_a, &q.from_a});
  const IntegerVector side = scaled(u, exponent);
  return {ExactApex(scaled(p.from_a, exponent), side),
          ExactApex(scaled(q.from_a, exponent), side)};
}

/** \brief Maximum rounding error of the difference between dot cross of one apex and
 * cross dot of the other. */
double
errorOfCotangents(const Apex& p, const Apex& q, const Eigen::Vector3d& u)
{
  const double length_p = p.from_a.norm(), length_q = q.from_a.norm();
  return 1e-14 * u.norm() * length_p * length_q * (2 * u.norm() + length_p + length_q);
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
  const double bound = errorOfCotangents(p, q, u);
  if (left < right - bound)
    return true;
  if (left > right + bound)
    return false;
  const std::array<ExactApex, 2> exact = exactApexes(p, q, u);
  const int sign = compareCotangents(exact[0], exact[1], &ExactApex::at_apex);
  return sign != 0 ? sign < 0 : winsTie(p.index, q.index, a, b, exact);
}

bool
hasSmallerCircle(const Apex& p,
                 const Apex& q,
                 std::int32_t a,
                 std::int32_t b,
                 const Eigen::Vector3d& u)
{
  const double left = std::abs(p.dot) * q.cross, right = std::abs(q.dot) * p.cross;
  const double bound = errorOfCotangents(p, q, u);
  if (left < right - bound)
    return true;
  if (left > right + bound)
    return false;
  std::array<ExactApex, 2> exact = exactApexes(p, q, u);
  for (ExactApex& apex : exact)
    apex.at_apex = abs(apex.at_apex);
  const int sign = compareCotangents(exact[0], exact[1], &ExactApex::at_apex);
  return sign != 0 ? sign < 0 : isNearerApex(p, q, a, b, u);
}

} // namespace pcl::acmap::dewall
