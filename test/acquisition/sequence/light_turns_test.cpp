#include "sequence/light_turns.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

constexpr double tail = 0.35;

/** Six changes of the light, each sampled every tenth of a second after a different
 * delay. */
template <typename Level>
std::vector<LightTurn>
turnsOf(const Level& level)
{
  std::vector<LightTurn> turns(6);
  for (std::size_t i = 0; i < turns.size(); ++i)
    for (double delay = 0.033 * double(i / 2); delay < 0.6; delay += 0.1)
      turns[i].push_back({delay, static_cast<double>(level(i, delay))});
  return turns;
}

/** Changes between 20 and 60, all at once after 0.12 s. */
std::vector<LightTurn>
suddenTurns()
{
  return turnsOf([](std::size_t turn, double delay) {
    const bool has_changed = delay >= 0.12;
    return (turn % 2 == 1) == has_changed ? 60 : 20;
  });
}

TEST(LightTurns, TheShotBehindTheLastUnsettledOneCounts)
{
  const auto found = findLightChange(suddenTurns(), tail);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->settled, 0.133, 1e-9) << "0.1 is too early, 0.133 is next";
}

TEST(LightTurns, ChangesAreCompleteNearTheirEnds)
{
  const auto change = findLightChange(suddenTurns(), tail);
  ASSERT_TRUE(change);
  EXPECT_TRUE(change->isComplete(59, true));
  EXPECT_FALSE(change->isComplete(57, true));
  EXPECT_TRUE(change->isComplete(21, false));
  EXPECT_FALSE(change->isComplete(23, false));
}

TEST(LightTurns, TheLongestOfAllChangesCounts)
{
  const auto found = findLightChange(turnsOf([](std::size_t turn, double delay) {
                                       const bool has_changed =
                                           delay >= (turn == 4 ? 0.3 : 0.05);
                                       return (turn % 2 == 1) == has_changed ? 60 : 20;
                                     }),
                                     tail);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->settled, 0.3, 1e-9);
}

TEST(LightTurns, AFadeIsWaitedForAlmostToItsEnd)
{
  const auto found =
      findLightChange(turnsOf([](std::size_t turn, double delay) {
                        const double part = std::min(1.0, delay / 0.2);
                        return turn % 2 == 1 ? 20 + 100 * part : 120 - 100 * part;
                      }),
                      tail);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->settled, 0.2, 1e-9) << "0.166 has 83 % of the change";
}

TEST(LightTurns, NoiseIsNotWaitedFor)
{
  Random random(3);
  const auto found = findLightChange(
      turnsOf([&](std::size_t turn, double delay) {
        const bool has_changed = delay >= 0.05;
        return ((turn % 2 == 1) == has_changed ? 60.0 : 50.0) + random.uniform(-.5, .5);
      }),
      tail);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->settled, 0.066, 1e-9);
}

TEST(LightTurns, WhatDoesNotFollowTheTurnsIsNoChange)
{
  Random random(4);
  const auto none = [&](const auto& level) {
    return !findLightChange(turnsOf(level), tail);
  };
  EXPECT_TRUE(none([](std::size_t, double) { return 50.0; }));
  EXPECT_TRUE(none([&](std::size_t, double) { return 50 + 0.1 * random.normal(); }));
  EXPECT_TRUE(none([&](std::size_t, double) { return 50 + 40 * random.normal(); }));
  EXPECT_TRUE(none([](std::size_t turn, double) { return 50.0 + 9.0 * double(turn); }));
  EXPECT_TRUE(none([](std::size_t turn, double) { return turn % 2 ? 20.0 : 60.0; }))
      << "the other way round";
  EXPECT_TRUE(none([](std::size_t turn, double delay) {
    return (turn % 2 == 1) == (delay >= 0.45) ? 60.0 : 20.0;
  })) << "too late";
}

} // namespace
} // namespace pcl::acmap::test
