#include "polygon_checks.h"

#include "outlines/loop.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

using outlines::Loop;

Loop
makeSquare(double side)
{
  return {{0, 0}, {side, 0}, {side, side}, {0, side}};
}

/** Random vertices of a self-intersecting loop. */
Loop
makeTangle(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  Loop loop;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = random.uniform(), y = random.uniform();
    loop.emplace_back(x, y);
  }
  return loop;
}

/** A simple star around the origin. */
Loop
makeStar(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  Loop loop;
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(size);
    loop.push_back(random.uniform(0.5, 1) *
                   Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

TEST(Loop, hasASignedArea)
{
  Loop square = makeSquare(3);
  EXPECT_DOUBLE_EQ(outlines::signedArea(square), 9);
  std::reverse(square.begin(), square.end());
  EXPECT_DOUBLE_EQ(outlines::signedArea(square), -9);
  EXPECT_EQ(outlines::signedArea({}), 0);
  EXPECT_EQ(outlines::signedArea({{1, 2}}), 0);
  EXPECT_EQ(outlines::signedArea({{1, 2}, {3, 4}}), 0);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Loop star = makeStar(40, seed);
    EXPECT_NEAR(outlines::signedArea(star), areaOf(star), 1e-12);
  }
}

TEST(Loop, containsWhatItGoesRound)
{
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Loop star = makeStar(25, seed);
    Random random(seed);
    for (int k = 0; k < 500; ++k) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      EXPECT_EQ(outlines::contains(star, {x, y}), isInside(star, {x, y}));
    }
  }
}

TEST(Loop, isSimplifiedToItsCorners)
{
  Loop fine;
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < 50; ++k) {
      const double along = 0.02 * k;
      fine.push_back(
          std::vector<Eigen::Vector2d>{{along, 0},
                                       {1, along},
                                       {1 - along, 1},
                                       {0, 1 - along}}[static_cast<std::size_t>(side)]);
    }
  const Loop coarse = outlines::simplified(fine, 1e-6);
  EXPECT_EQ(coarse.size(), 4U);
  EXPECT_NEAR(outlines::signedArea(coarse), 1, 1e-9);
}

TEST(Loop, leavesOutOnlyWhatIsNear)
{
  for (const std::uint64_t seed : {1, 2, 3, 4})
    for (const double tolerance : {0.01, 0.1, 0.4}) {
      const Loop fine = makeStar(200, seed);
      const Loop coarse = outlines::simplified(fine, tolerance);
      ASSERT_GE(coarse.size(), 2U);
      EXPECT_LE(coarse.size(), fine.size());
      for (const Eigen::Vector2d& point : fine)
        EXPECT_LE(distanceToLine(coarse, point), tolerance + 1e-12);
      for (const Eigen::Vector2d& point : coarse)
        EXPECT_NE(std::find(fine.begin(), fine.end(), point), fine.end());
    }
}

TEST(Loop, shortOnesStay)
{
  EXPECT_EQ(outlines::simplified({}, 1).size(), 0U);
  const Loop triangle{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(outlines::simplified(triangle, 10), triangle);
  const Loop same(20, Eigen::Vector2d(3, 4));
  EXPECT_LE(outlines::simplified(same, 0.1).size(), 2U);
}

TEST(Loop, figureOfEightLosesItsSmallerHalf)
{
  const Loop eight{{0, 0}, {4, 0}, {4, 2}, {-1, -1}, {-1, 2}, {0, 2}};
  ASSERT_GT(countCrossings(eight), 0U);
  const Loop simple = outlines::uncrossed(eight);
  EXPECT_EQ(countCrossings(simple), 0U);
  const Loop square = makeSquare(2);
  EXPECT_EQ(outlines::uncrossed(square), square);
}

TEST(Loop, tanglesBecomeSimple)
{
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Loop tangle = makeTangle(4 + seed % 30, seed);
    const Loop simple = outlines::uncrossed(tangle);
    EXPECT_EQ(countCrossings(simple), 0U) << "seed " << seed;
    EXPECT_GE(simple.size(), 3U);
    for (const Eigen::Vector2d& point : simple)
      EXPECT_LT(distanceToLine(tangle, point), 1e-9) << "seed " << seed;
  }
}

} // namespace
} // namespace pcl::acmap::test
