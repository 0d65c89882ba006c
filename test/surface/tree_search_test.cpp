#include "clouds.h"
#include "dewall/apex_search.h"
#include "dewall/third_point.h"
#include "dewall/tree_search.h"
#include "tested_variant.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace pcl::acmap::test {
namespace {

using namespace ACMAP_DEWALL;

class TreeSearch : public VariantTest {};

std::unique_ptr<PointTree>
treeOf(const Cloud& cloud)
{
  SourcePoints points;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    points.push_back(
        {{cloud[i].x, cloud[i].y, cloud[i].z}, static_cast<std::int32_t>(i)});
  return std::make_unique<PointTree>(std::move(points));
}

/** Clouds with and without noise, with large coordinates, and with many exact ties. */
std::vector<Cloud>
clouds()
{
  return {makeJitteredPlane({20, 20, 1, 0.25, 0.3, 1}).cloud,
          makeRandomBox(700, 2),
          makeGrid(15, 15, 0.25, ExactPlane::Level),
          moved(makeRandomBox(300, 3),
                Eigen::Isometry3d(Eigen::Translation3d(3000, -5000, 800)))};
}

std::int32_t
pickPoint(const PointTree& tree, Random& random)
{
  return static_cast<std::int32_t>(random.bits() %
                                   static_cast<std::uint64_t>(tree.size()));
}

bool
contains(const SearchHits& hits, std::int32_t index)
{
  return std::find(hits.index, hits.index + hits.count, index) !=
         hits.index + hits.count;
}

/** The apex of an edge, by checking every point in double precision. */
std::int32_t
apexByBruteForce(const PointTree& tree,
                 const SizeConstraint& size,
                 const SideFrame& side,
                 const PassedOver& passed_over)
{
  Apex best;
  for (std::int32_t i = 0; i < tree.size(); ++i) {
    if (i == side.a || i == side.b || passed_over.contains(tree, i))
      continue;
    const Apex apex = makeApex(i, side.u, tree.position(i) - side.origin);
    if (isApexAllowed(size, side, apex) &&
        (best.index < 0 || isNearerApex(apex, best, side.a, side.b, side.u)))
      best = apex;
  }
  return best.index;
}

TEST_F(TreeSearch, findsTheApexOfBruteForce)
{
  for (const Cloud& cloud : clouds()) {
    const auto tree = treeOf(cloud);
    std::vector<std::uint16_t> masks(static_cast<std::size_t>(tree->leafCount()));
    Random random(7);
    for (std::uint16_t& mask : masks)
      mask = static_cast<std::uint16_t>(random.bits());
    const SizeConstraint size(*tree, 3);
    for (int trial = 0; trial < 2000; ++trial) {
      const auto pick = [&] { return pickPoint(*tree, random); };
      const std::int32_t a = pick(), b = pick(), opposite = pick();
      if (a == b || a == opposite || b == opposite)
        continue;
      if (isDegenerate(tree->position(a), tree->position(b), tree->position(opposite)))
        continue;
      const SideFrame side(*tree, size, a, b, opposite);
      PassedOver passed_over;
      passed_over.point = pick();
      passed_over.masks = masks.data();
      passed_over.end_leaf = trial % 2 ? tree->leafCount() / 2 : 0;
      ASSERT_EQ(findApex(*tree, size, side, passed_over),
                apexByBruteForce(*tree, size, side, passed_over));
    }
  }
}

/** The third point of the first triangle: on either side, within the size constraint. */
TEST_F(TreeSearch, findsTheThirdPointOfBruteForce)
{
  for (const Cloud& cloud : clouds()) {
    const auto tree = treeOf(cloud);
    const SizeConstraint size(*tree, 3);
    Random random(8);
    std::size_t found = 0;
    for (int trial = 0; trial < 1000; ++trial) {
      const std::int32_t a = pickPoint(*tree, random), b = pickPoint(*tree, random);
      const auto isAccepted = [](std::int32_t i) { return i % 3 != 0; };
      if (a == b)
        continue;
      std::int32_t best = -1;
      double smallest = std::numeric_limits<double>::infinity();
      for (std::int32_t i = 0; i < tree->size(); ++i) {
        const Eigen::Vector3d &p = tree->position(a), &q = tree->position(b),
                              &r = tree->position(i);
        if (i == a || i == b || !isAccepted(i) || (r - p).norm() > 3 ||
            (r - q).norm() > 3 || isDegenerate(p, q, r))
          continue;
        if (const double radius = smallestSphere(p, q, r).radius; radius < smallest) {
          smallest = radius;
          best = i;
        }
      }
      ASSERT_EQ(findThirdPoint(*tree, size, a, b, isAccepted), best);
      found += best >= 0;
    }
    EXPECT_GT(found, 10U);
  }
}

/** The hits include the point with the smallest circle beyond plane
 * beta. */
TEST_F(TreeSearch, findsTheSmallestCircleOfBruteForce)
{
  for (const Cloud& cloud : clouds()) {
    const auto tree = treeOf(cloud);
    Random random(9);
    for (int trial = 0; trial < 1500; ++trial) {
      const auto pick = [&] { return pickPoint(*tree, random); };
      const std::int32_t a = pick(), b = pick(), opposite = pick();
      if (a == b || a == opposite || b == opposite ||
          isDegenerate(tree->position(a), tree->position(b), tree->position(opposite)))
        continue;
      const SideFrame side(*tree, 1e3, a, b, opposite);
      Apex best;
      for (std::int32_t i = 0; i < tree->size(); ++i) {
        const Apex apex = makeApex(i, side.u, tree->position(i) - side.origin);
        if (i != a && i != b && apex.from_a.dot(side.outward) > 0 &&
            apex.cross > 1e-3 &&
            (best.index < 0 || hasSmallerCircle(apex, best, a, b, side.u)))
          best = apex;
      }
      SearchHits hits;
      findCircleCandidates(tree->cells(), apexQuery(*tree, side), hits);
      if (best.index >= 0 && hits.count <= SearchHits::capacity) {
        ASSERT_TRUE(contains(hits, best.index));
      }
    }
  }
}

TEST_F(TreeSearch, knowsWhatLiesInABall)
{
  for (const Cloud& cloud : clouds()) {
    const auto tree = treeOf(cloud);
    Random random(11);
    for (int trial = 0; trial < 3000; ++trial) {
      std::array<std::int32_t, 3> corners;
      for (std::int32_t& corner : corners)
        corner = pickPoint(*tree, random);
      if (isDegenerate(tree->position(corners[0]),
                       tree->position(corners[1]),
                       tree->position(corners[2])))
        continue;
      const Sphere sphere = sphereOf(*tree, corners);
      const double inside = sphere.radius * (1 - sphere_tolerance);
      bool is_empty = true;
      for (std::int32_t i = 0; i < tree->size(); ++i)
        is_empty &= i == corners[0] || i == corners[1] || i == corners[2] ||
                    (tree->position(i) - sphere.centre).norm() >= inside;
      const BallQuery query = ballQuery(*tree, corners, sphere);
      SearchHits hits;
      const bool is_occupied = findInBall(tree->cells(), query, hits);
      bool holds = is_occupied;
      for (std::int32_t i = 0; i < tree->size(); ++i) {
        const bool is_inside = (tree->position(i) - sphere.centre).norm() < inside &&
                               std::count(corners.begin(), corners.end(), i) == 0;
        holds |= is_inside && hits.count <= SearchHits::capacity && contains(hits, i);
      }
      if (hits.count <= SearchHits::capacity) {
        EXPECT_EQ(holds, !is_empty);
      }
      EXPECT_EQ(isSphereEmpty(*tree, corners), is_empty);
    }
  }
}

TEST_F(TreeSearch, manyPointsOnOneCircleAreTied)
{
  Cloud ring;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / 400;
    ring.emplace_back(
        static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F);
  }
  const auto tree = treeOf(ring);
  const SizeConstraint size(*tree, 10);
  const SideFrame side(*tree, size, 0, 200, 399);
  EXPECT_EQ(findApex(*tree, size, side, {}), apexByBruteForce(*tree, size, side, {}));
}

} // namespace
} // namespace pcl::acmap::test
