#include <pcl/core/random.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(Random, givesTheReferenceValuesOfSplitMix64)
{
  Random random(1234567);
  for (const std::uint64_t expected : {6457827717110365317U,
                                       3203168211198807973U,
                                       9817491932198370423U,
                                       4593380528125082431U,
                                       16408922859458223821U})
    EXPECT_EQ(random.bits(), expected);
}

TEST(Random, streamsOfOtherSeedsDiffer)
{
  EXPECT_NE(Random(1).bits(), Random(2).bits());
  EXPECT_EQ(Random(7).normal(), Random(7).normal());
}

TEST(Random, uniformFillsItsRange)
{
  Random random(5);
  constexpr int count = 200000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double value = random.uniform(-2.0, 4.0);
    ASSERT_GE(value, -2.0);
    ASSERT_LT(value, 4.0);
    sum += value;
    squares += (value - 1.0) * (value - 1.0);
  }
  EXPECT_NEAR(sum / count, 1.0, 0.02);
  EXPECT_NEAR(squares / count, 36.0 / 12.0, 0.02);
}

TEST(Random, normalHasItsMoments)
{
  Random random(5);
  constexpr int count = 200000;
  double moments[5] = {};
  for (int i = 0; i < count; ++i) {
    const double value = random.normal();
    double power = 1.0;
    for (double& moment : moments) {
      moment += power / count;
      power *= value;
    }
  }
  EXPECT_NEAR(moments[1], 0.0, 0.01);
  EXPECT_NEAR(moments[2], 1.0, 0.015);
  EXPECT_NEAR(moments[3], 0.0, 0.04);
  EXPECT_NEAR(moments[4], 3.0, 0.1);
}

} // namespace
} // namespace pcl::acmap::test
