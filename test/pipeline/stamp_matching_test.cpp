#include "rgbd/stamp_matching.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/** Brute-force reference: all pairs, the closest first. */
Pairs
matchedByAllPairs(const std::vector<double>& first,
                  const std::vector<double>& second,
                  double gap)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> all;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j)
      if (std::abs(first[i] - second[j]) <= gap)
        all.emplace_back(std::abs(first[i] - second[j]), i, j);
  std::sort(all.begin(), all.end());
  std::vector<bool> first_used(first.size());
  std::vector<bool> second_used(second.size());
  Pairs pairs;
  for (const auto& [distance, i, j] : all)
    if (!first_used[i] && !second_used[j]) {
      first_used[i] = second_used[j] = true;
      pairs.emplace_back(i, j);
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<double>
randomStamps(Random& random, std::size_t count)
{
  std::vector<double> stamps;
  for (std::size_t i = 0; i < count; ++i)
    stamps.push_back(random.normal());
  std::sort(stamps.begin(), stamps.end());
  return stamps;
}

TEST(StampMatching, IsThatOfAllPairs)
{
  Random random(3);
  std::size_t matched = 0;
  for (std::size_t round = 0; round < 200; ++round) {
    const auto first = randomStamps(random, round % 23);
    const auto second = randomStamps(random, round % 31);
    for (const double gap : {0.01, 0.1, 10.0}) {
      const Pairs pairs = matchStamps(first, second, gap);
      ASSERT_EQ(pairs, matchedByAllPairs(first, second, gap)) << round;
      matched += pairs.size();
    }
  }
  EXPECT_GT(matched, 2000u);
}

TEST(StampMatching, EachStampIsUsedOnce)
{
  EXPECT_EQ(matchStamps({1, 1, 1}, {1, 1}, 0).size(), 2u);
  EXPECT_EQ(matchStamps({0, 0.03}, {0.016}, 0.02), (Pairs{{1, 0}}));
  EXPECT_EQ(matchStamps({0, 1}, {0.5}, 0.4), Pairs());
  EXPECT_EQ(matchStamps({}, {1}, 9), Pairs());
}

TEST(StampMatching, ManyEqualStampsAreQuick)
{
  const std::vector<double> same(100000, 5.0);
  EXPECT_EQ(matchStamps(same, same, 1.0).size(), 100000u);
}

} // namespace
} // namespace pcl::acmap::test
