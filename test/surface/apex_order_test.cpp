#include "dewall/predicates.h"
#include "tested_variant.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <vector>

namespace pcl::acmap::test {
namespace {

using ACMAP_DEWALL::Apex;
using ACMAP_DEWALL::hasSmallerCircle;
using ACMAP_DEWALL::isNearerApex;
using ACMAP_DEWALL::makeApex;

/** An edge of a lattice with all its possible apexes: many are on one circle, and many
 * more on circles of the same size around the edge. Indices are scattered as in a
 * tree. */
struct LatticeSide {
  std::int32_t a, b;
  Eigen::Vector3d u;
  std::vector<Apex> apexes;

  LatticeSide(std::int32_t a_index, std::int32_t b_index, const Eigen::Vector3d& along)
  : a(a_index)
  , b(b_index)
  , u(along)
  {
    constexpr int half = 2, points = 125;
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector3d v(
          i % 5 - half, i / 5 % 5 - half, static_cast<double>(i / 25) - half);
      const std::int32_t index = i * 57 % points + (i % 2 ? 0 : 200);
      if (u.cross(v).norm() > 0 && index != a && index != b)
        apexes.push_back(makeApex(index, u, v));
    }
  }

  bool
  isNearer(const Apex& p, const Apex& q) const
  {
    return isNearerApex(p, q, a, b, u);
  }
};

std::vector<LatticeSide>
latticeSides()
{
  std::vector<LatticeSide> sides;
  for (const Eigen::Vector3d& along :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, -2, 1)})
    for (const std::int32_t a : {-1, 150, 400})
      for (const std::int32_t b : {-2, 151, 401})
        sides.emplace_back(a, b, along);
  return sides;
}

class ApexOrder : public VariantTest {};

/** std::sort requires a strict weak order; otherwise it accesses memory out of
 * bounds. */
TEST_F(ApexOrder, isOneOfAllCandidates)
{
  for (const LatticeSide& side : latticeSides())
    for (const Apex& p : side.apexes) {
      ASSERT_FALSE(side.isNearer(p, p));
      for (const Apex& q : side.apexes) {
        if (p.index == q.index)
          continue;
        ASSERT_NE(side.isNearer(p, q), side.isNearer(q, p))
            << p.index << " " << q.index;
        if (!side.isNearer(p, q))
          continue;
        for (const Apex& r : side.apexes)
          ASSERT_TRUE(!side.isNearer(q, r) || side.isNearer(p, r))
              << p.index << " " << q.index << " " << r.index;
      }
    }
}

/** Squared radii are |ap|^2 |bp|^2 |ab|^2 / (4 |u x v|^2), exact in doubles here; ties are
 * those of the other order. */
TEST_F(ApexOrder, smallestCircleIsThatOfRadii)
{
  for (const LatticeSide& side : latticeSides())
    for (const Apex& p : side.apexes)
      for (const Apex& q : side.apexes) {
        const auto radius = [&](const Apex& apex, const Apex& other) {
          return apex.from_a.squaredNorm() * (apex.from_a - side.u).squaredNorm() *
                 side.u.cross(other.from_a).squaredNorm();
        };
        const double of_p = radius(p, q), of_q = radius(q, p);
        ASSERT_EQ(hasSmallerCircle(p, q, side.a, side.b, side.u),
                  of_p != of_q ? of_p < of_q : side.isNearer(p, q));
      }
}

/** The order must not depend on the direction of the edge. */
TEST_F(ApexOrder, isThatOfTheTurnedSide)
{
  for (const LatticeSide& side : latticeSides()) {
    const auto turned = [&](const Apex& apex) {
      return makeApex(apex.index, -side.u, apex.from_a - side.u);
    };
    for (const Apex& p : side.apexes)
      for (const Apex& q : side.apexes)
        ASSERT_EQ(side.isNearer(p, q),
                  isNearerApex(turned(p), turned(q), side.b, side.a, -side.u))
            << p.index << " " << q.index;
  }
}

/** A vector of whole numbers with at most so many bits. */
Eigen::Vector3d
makeLatticeVector(int bits, Random& random)
{
  const auto pick = [&] {
    const auto magnitude =
        static_cast<double>(random.bits() & ((std::uint64_t{1} << bits) - 1));
    return random.bits() % 2 ? magnitude : -magnitude;
  };
  const double x = pick(), y = pick(), z = pick();
  return {x, y, z};
}

/** Candidates over an edge: random ones, ones of the same circles, circles of the same
 * size, and degenerate ones. */
std::vector<Apex>
makeCandidates(const Eigen::Vector3d& u, int bits, Random& random)
{
  std::vector<Eigen::Vector3d> all{u, -u, 2 * u, Eigen::Vector3d::Zero()};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d v = makeLatticeVector(bits, random);
    all.insert(all.end(), {v, u - v, Eigen::Vector3d(-v), u + v});
  }
  std::vector<Apex> candidates;
  for (const Eigen::Vector3d& v : all)
    candidates.push_back(
        makeApex(static_cast<std::int32_t>(random.bits() % 1000), u, v));
  return candidates;
}

/** Times an odd factor, the coordinates need so many bits more that they are decided in
 * integers without a limit. The decisions must be the same. */
TEST_F(ApexOrder, isTheSameInIntegersOfAnySize)
{
  Random random(12);
  for (const int bits : {1, 3, 10, 20, 26, 27, 28})
    for (int trial = 0; trial < 40; ++trial) {
      const double factor = bits < 22 ? 0x1p30 + 1 : 33;
      const Eigen::Vector3d u = makeLatticeVector(bits, random);
      const std::vector<Apex> candidates = makeCandidates(u, bits, random);
      const auto larger = [&](const Apex& apex) {
        return makeApex(apex.index, factor * u, factor * apex.from_a);
      };
      for (const Apex& p : candidates)
        for (const Apex& q : candidates) {
          const auto isSame = [&](auto isBetter) {
            return isBetter(p, q, 500, 400, u) ==
                   isBetter(larger(p), larger(q), 500, 400, factor * u);
          };
          ASSERT_TRUE(isSame(isNearerApex)) << bits << " bits, trial " << trial;
          ASSERT_TRUE(isSame(hasSmallerCircle)) << bits << " bits, trial " << trial;
        }
    }
}

/** Four points on a circle: the diagonal starts at the lowest index. */
TEST_F(ApexOrder, lowestOfACircleIsJoined)
{
  const Eigen::Vector3d u(3, 0, 0), left(0, 4, 0), right(3, 4, 0);
  const auto isRightNearer = [&](std::int32_t a, std::int32_t b) {
    return isNearerApex(makeApex(8, u, right), makeApex(9, u, left), a, b, u);
  };
  EXPECT_TRUE(isRightNearer(1, 2)) << "the diagonal from a to the right";
  EXPECT_FALSE(isRightNearer(2, 1)) << "from b to the left";
  EXPECT_TRUE(isRightNearer(11, 12)) << "from the right itself";
}

} // namespace
} // namespace pcl::acmap::test
