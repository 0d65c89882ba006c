#include "outlines/loop.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using outlines::disentangled;
using outlines::Loop;
using outlines::signedArea;

constexpr double distance = 1e-4;

double
areaOfAll(const std::vector<Loop>& loops)
{
  double area = 0;
  for (const Loop& loop : loops)
    area += signedArea(loop);
  return area;
}

const Loop square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(LoopCrossings, LoopsThatKeepTheirDistanceStay)
{
  const std::vector<Loop> loops{square, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  EXPECT_EQ(disentangled(loops, distance), loops);
  EXPECT_TRUE(disentangled({}, distance).empty());
}

TEST(LoopCrossings, HoleAcrossTheRimIsABay)
{
  const auto loops = disentangled({square, {{3, 1}, {3, 2}, {5, 2}, {5, 1}}}, distance);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].size(), 8U);
  EXPECT_NEAR(areaOfAll(loops), 15, 1e-9);
}

TEST(LoopCrossings, OverlappingHolesAndRimsAreOne)
{
  const Loop a{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const Loop b{{1.5, 1.5}, {1.5, 3}, {3, 3}, {3, 1.5}};
  const auto holes = disentangled({square, a, b}, distance);
  EXPECT_EQ(holes.size(), 2U);
  EXPECT_NEAR(areaOfAll(holes), 16 - 1 - 2.25 + 0.25, 1e-9);
  const auto rims = disentangled({square, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}, distance);
  EXPECT_EQ(rims.size(), 1U);
  EXPECT_NEAR(areaOfAll(rims), 16 + 9 - 1, 1e-9);
}

TEST(LoopCrossings, BothPartsOfANeckStay)
{
  // A corner that touches the opposite edge, except for rounding errors in both
  // directions.
  for (const double off : {-1e-6, 0.0, 1e-6}) {
    const auto loops =
        disentangled({{{0, 0}, {4, 0}, {8, 0}, {8, 4}, {4, off}, {0, 4}}}, distance);
    ASSERT_EQ(loops.size(), 2U) << off;
    EXPECT_NEAR(areaOfAll(loops), 16, 1e-4);
    EXPECT_GT(signedArea(loops[0]), 7);
    EXPECT_GT(signedArea(loops[1]), 7);
  }
}

TEST(LoopCrossings, SpikesAndLoopsWithoutAreaGo)
{
  const auto spiked = disentangled(
      {{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 9}, {2, 4}, {0, 4}}}, distance);
  ASSERT_EQ(spiked.size(), 1U);
  EXPECT_NEAR(areaOfAll(spiked), 16, 1e-9);
  EXPECT_TRUE(disentangled({{{0, 0}, {1, 0}, {2, 0}}}, distance).empty());
  EXPECT_TRUE(disentangled({Loop(5, {1, 1})}, distance).empty());
}

/** Each corner of such a triangle is near the opposite edge; this edge was split there,
 * and then its parts again. */
TEST(LoopCrossings, SmallTrianglesComeToAnEnd)
{
  for (const double side : {0.9, 1.0, 1.05, 1.15, 1.3, 2.0, 2.5}) {
    const double d = side * distance;
    const auto loops = disentangled(
        {square, {{1, 1}, {1 + d / 2, 1 + d * 0.85}, {1 + d, 1}}}, distance);
    EXPECT_NEAR(areaOfAll(loops), 16, 1e-7) << side;
  }
}

/** Because of rounding, split points beside their edges caused hundreds of thousands of
 * new crossings. */
TEST(LoopCrossings, LoopsFarAwayAreCutAsFarAsNumbersTell)
{
  constexpr double far = -82083207153158, ulp = 1.0 / 64, across = 1494.75,
                   y = -4885924;
  const Eigen::Vector2d a(far, y), b(far + 2 * ulp, y - 2), c(far + across, 994995754);
  const Eigen::Vector2d d(far + 2 * ulp, y), e(far + across + 2 * ulp, c.y());
  const Eigen::Vector2d f(far + 3 * ulp, y - 2), g(far + 5 * ulp, y);
  const Eigen::Vector2d h(far + 5 * ulp, y - 2), i(far + 3 * ulp, y - 0.9999043169);
  const std::vector<Loop> loops{
      {g, h, c}, {e, a, d, b}, {d, b, c}, {c, a, b}, {f, e, a, b, i}};
  for (const Loop& loop : disentangled(loops, 2.95e-5))
    EXPECT_LE(loop.size(), 20U);
}

} // namespace
} // namespace pcl::acmap::test
