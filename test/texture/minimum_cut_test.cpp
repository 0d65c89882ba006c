#include "texturing/minimum_cut.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace pcl::acmap::test {
namespace {

/** Costs of a pair of nodes: both stay, the second moves, the first moves, both move. */
struct PairCost {
  std::size_t first, second;
  std::array<std::int64_t, 4> of;
};

struct Costs {
  std::vector<std::array<std::int64_t, 2>> nodes; ///< of staying and of moving
  std::vector<PairCost> pairs;

  std::int64_t
  sum(const std::vector<bool>& moves) const
  {
    std::int64_t all = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      all += nodes[n][moves[n] ? 1 : 0];
    for (const PairCost& pair : pairs)
      all += pair.of[(moves[pair.first] ? 2 : 0) + (moves[pair.second] ? 1 : 0)];
    return all;
  }

  std::int64_t
  smallestSum() const
  {
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t bits = 0; bits < std::size_t{1} << nodes.size(); ++bits) {
      std::vector<bool> moves;
      for (std::size_t n = 0; n < nodes.size(); ++n)
        moves.push_back((bits >> n & 1) == 1);
      smallest = std::min(smallest, sum(moves));
    }
    return smallest;
  }
};

/** Random costs of ten nodes; those of pairs are submodular. */
Costs
randomCosts(std::uint64_t seed)
{
  constexpr std::size_t nodes = 10;
  Random random(seed);
  const auto some = [&] { return static_cast<std::int64_t>(random.uniform(0, 100)); };
  Costs costs;
  for (std::size_t n = 0; n < nodes; ++n)
    costs.nodes.push_back({some(), some()});
  for (std::size_t a = 0; a < nodes; ++a)
    for (std::size_t b = a + 1; b < nodes; ++b)
      if (random.uniform() < 0.4) {
        const std::int64_t stay = some(), move = some(), second = some();
        costs.pairs.push_back(
            {a,
             b,
             {stay,
              second,
              std::max<std::int64_t>(stay + move - second, 0) + some(),
              move}});
      }
  return costs;
}

TEST(MinimumCut, NoOtherChoiceCostsLess)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Costs costs = randomCosts(seed);
    texturing::MinimumCut cut(costs.nodes.size());
    for (std::size_t n = 0; n < costs.nodes.size(); ++n)
      cut.add(n, costs.nodes[n][0], costs.nodes[n][1]);
    for (const PairCost& pair : costs.pairs)
      cut.addPair(
          pair.first, pair.second, pair.of[0], pair.of[1], pair.of[2], pair.of[3]);
    EXPECT_EQ(costs.sum(cut.solve()), costs.smallestSum()) << seed;
  }
}

TEST(MinimumCut, EqualCostsStay)
{
  texturing::MinimumCut cut(3);
  EXPECT_EQ(cut.solve(), std::vector<bool>(3, false));
}

} // namespace
} // namespace pcl::acmap::test
