#include "predicates.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Integers without a limit, for coordinates of any range. */
using AnyInteger = boost::multiprecision::cpp_int;

template <typename Integer>
using IntegerVector = std::array<Integer, 3>;

/** \brief The largest power of two of which all coordinates are multiples. */
struct CommonUnit {
  int exponent = 1 << 20;
  int bits = 0; ///< enough for the magnitude of each coordinate in this unit
};

CommonUnit
commonUnit(std::initializer_list<const Eigen::Vector3d*> vectors)
{
  CommonUnit unit;
  int largest = -(1 << 20);
  for (const Eigen::Vector3d* v : vectors)
    for (int axis = 0; axis < 3; ++axis)
      if ((*v)[axis] != 0) {
        int exponent = 0;
        const double mantissa = std::frexp((*v)[axis], &exponent);
        const auto digits = static_cast<std::uint64_t>(std::abs(mantissa) * 0x1p53);
        unit.exponent =
            std::min(unit.exponent, exponent - 53 + __builtin_ctzll(digits));
        largest = std::max(largest, exponent);
      }
  unit.bits = std::max(0, largest - unit.exponent);
  return unit;
}

void
scale(double value, int exponent, AnyInteger& result)
{
  if (value == 0)
    return;
  int own = 0;
  const double mantissa = std::frexp(value, &own);
  result = static_cast<std::int64_t>(mantissa * 0x1p53);
  const int shift = own - 53 - exponent;
  if (shift > 0)
    result <<= shift;
  else
    result /= AnyInteger(1) << -shift;
}

int
compareProducts(const AnyInteger& a,
                const AnyInteger& b,
                const AnyInteger& c,
                const AnyInteger& d)
{
  return AnyInteger(a * b).compare(c * d);
}

__extension__ using Integer128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

/** \brief Maximum number of bits of coordinates that are decided in 128-bit integers:
 * the cosines have at most 61 bits, the sines 120, the products that are compared
 * 242. */
constexpr int max_short_bits = 29;

void
scale(double value, int exponent, Integer128& result)
{
  result = static_cast<std::int64_t>(std::ldexp(value, -exponent));
}

/** \brief The product of two 128-bit integers. */
struct Product256 {
  Unsigned128 high, low;

  Product256(Unsigned128 a, Unsigned128 b)
  {
    const auto a_low = static_cast<std::uint64_t>(a);
    const auto b_low = static_cast<std::uint64_t>(b);
    const Unsigned128 a_high = a >> 64, b_high = b >> 64;
    const Unsigned128 lowest = Unsigned128{a_low} * b_low;
    const Unsigned128 middle = a_high * b_low + (lowest >> 64);
    const Unsigned128 other = a_low * b_high + static_cast<std::uint64_t>(middle);
    low = (other << 64) | static_cast<std::uint64_t>(lowest);
    high = a_high * b_high + (middle >> 64) + (other >> 64);
  }

  bool
  operator<(const Product256& other) const
  {
    return high != other.high ? high < other.high : low < other.low;
  }
};

int
signOf(Integer128 value)
{
  return value < 0 ? -1 : value > 0;
}

int
compareProducts(Integer128 a, Integer128 b, Integer128 c, Integer128 d)
{
  const int left = signOf(a) * signOf(b), right = signOf(c) * signOf(d);
  if (left != right || left == 0)
    return left - right;
  const auto size = [](Integer128 value) {
    return static_cast<Unsigned128>(value < 0 ? -value : value);
  };
  const Product256 of_left(size(a), size(b)), of_right(size(c), size(d));
  return of_left < of_right ? -left : (of_right < of_left ? left : 0);
}

template <typename Integer>
IntegerVector<Integer>
scaled(const Eigen::Vector3d& v, int exponent)
{
  IntegerVector<Integer> result{};
  for (int axis = 0; axis < 3; ++axis)
    scale(v[axis], exponent, result[static_cast<std::size_t>(axis)]);
  return result;
}

template <typename Integer>
Integer
dot(const IntegerVector<Integer>& a, const IntegerVector<Integer>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Integer>
Integer
signedSquare(const Integer& value)
{
  return value < 0 ? Integer(-value * value) : Integer(value * value);
}

/** \brief Exact products for the triangle of a candidate p, in powers of the unit of u
 * and v = p - a. */
template <typename Integer>
struct ExactApex {
  Integer at_apex; ///< (a - p) . (b - p)
  Integer at_a;    ///< u . v
  Integer sine;    ///< |u x v|^2

  ExactApex(const IntegerVector<Integer>& v, const IntegerVector<Integer>& u)
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
template <typename Integer>
int
compareCotangents(const ExactApex<Integer>& p,
                  const ExactApex<Integer>& q,
                  Integer ExactApex<Integer>::*cosine)
{
  return compareProducts(
      signedSquare(p.*cosine), q.sine, signedSquare(q.*cosine), p.sine);
}

/** \brief Calls decide (p, q) with the exact products of two candidates. */
template <typename Decide>
bool
decideExactly(const Apex& p,
              const Apex& q,
              const Eigen::Vector3d& u,
              const Decide& decide)
{
  const CommonUnit unit = commonUnit({&u, &p.from_a, &q.from_a});
  const auto decideIn = [&](auto integer) {
    using Integer = decltype(integer);
    const IntegerVector<Integer> side = scaled<Integer>(u, unit.exponent);
    return decide(ExactApex<Integer>(scaled<Integer>(p.from_a, unit.exponent), side),
                  ExactApex<Integer>(scaled<Integer>(q.from_a, unit.exponent), side));
  };
  if (unit.bits <= max_short_bits)
    return decideIn(Integer128{});
  return decideIn(AnyInteger{});
}

/** \brief Decides between two candidates on one circle through a and b: returns true if
 * p is the apex over edge a b in the pulled triangulation. Candidates on several
 * circles of the same size around the edge are compared by their positions on these
 * circles, so that all candidates have one order. */
template <typename Integer>
bool
winsTie(std::int32_t p,
        std::int32_t q,
        std::int32_t a,
        std::int32_t b,
        const ExactApex<Integer>& exact_p,
        const ExactApex<Integer>& exact_q)
{
  if (std::min(p, q) < std::min(a, b))
    return p < q;
  // The order on the circle is a b p q if the angle b a p is the smaller one.
  const int p_follows_b =
      compareCotangents(exact_p, exact_q, &ExactApex<Integer>::at_a);
  return p_follows_b != 0 ? (p_follows_b > 0) == (a < b) : p < q;
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
  return decideExactly(p, q, u, [&](const auto& exact_p, const auto& exact_q) {
    using Exact = std::decay_t<decltype(exact_p)>;
    const int sign = compareCotangents(exact_p, exact_q, &Exact::at_apex);
    return sign != 0 ? sign < 0 : winsTie(p.index, q.index, a, b, exact_p, exact_q);
  });
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
  return decideExactly(p, q, u, [&](auto exact_p, auto exact_q) {
    using Exact = decltype(exact_p);
    for (Exact* exact : {&exact_p, &exact_q})
      if (exact->at_apex < 0)
        exact->at_apex = -exact->at_apex;
    const int sign = compareCotangents(exact_p, exact_q, &Exact::at_apex);
    return sign != 0 ? sign < 0 : isNearerApex(p, q, a, b, u);
  });
}

} // namespace pcl::acmap::ACMAP_DEWALL
