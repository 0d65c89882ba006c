#include "consolidation/thinning.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace pcl::acmap::test {
namespace {

constexpr double edge = 0.1; // metres

/** Candidates at random in a slab, four in the volume of a voxel, some of them strayed. */
LargeVector<Candidate>
randomCandidates(std::size_t count, Random& random)
{
  const double side = edge * std::sqrt(static_cast<double>(count) / 4);
  LargeVector<Candidate> candidates(count);
  for (std::size_t c = 0; c < count; ++c) {
    candidates[c].representative.point = Eigen::Vector3d(side * random.uniform(),
                                                         side * random.uniform(),
                                                         edge * random.uniform())
                                             .cast<float>();
    candidates[c].octants = random.uniform() < 0.8 ? 1 : 2;
    candidates[c].strayed =
        random.uniform() < 0.1 ? static_cast<float>(random.uniform()) : 0.0F;
  }
  return candidates;
}

/** The kept candidates by the definition: one after the other, each displaced by the
 * closest one that is kept and too close. */
class NaiveThinning {
public:
  explicit NaiveThinning(const LargeVector<Candidate>& candidates)
  : candidates_(candidates)
  , displaced_by(candidates.size(), -1)
  {
    std::vector<std::size_t> order(candidates.size());
    for (std::size_t c = 0; c < order.size(); ++c)
      order[c] = c;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return candidates[a].strayed < candidates[b].strayed;
    });
    for (const std::size_t c : order)
      decide(c);
  }

private:
  using Cell = std::array<int, 2>;

  Cell
  cellOf(const Eigen::Vector3f& point) const
  {
    return {static_cast<int>(std::floor(point.x() / edge)),
            static_cast<int>(std::floor(point.y() / edge))};
  }

  void
  decide(std::size_t c)
  {
    const Candidate& candidate = candidates_[c];
    const Eigen::Vector3f& point = candidate.representative.point;
    const double radius = (candidate.strayed > 0 ? 0.85 : 0.7) * edge;
    const Cell cell = cellOf(point);
    std::pair<float, std::size_t> closest{INFINITY, 0};
    for (int x = cell[0] - 1; x <= cell[0] + 1; ++x)
      for (int y = cell[1] - 1; y <= cell[1] + 1; ++y)
        for (const std::size_t other : kept_[{x, y}]) {
          const float distance =
              (candidates_[other].representative.point - point).squaredNorm();
          if ((candidates_[other].octants & candidate.octants) != 0 &&
              static_cast<double>(distance) < radius * radius)
            closest = std::min(closest, std::pair(distance, other));
        }
    if (std::isinf(closest.first))
      kept_[cell].push_back(c);
    else
      displaced_by[c] = static_cast<std::int64_t>(closest.second);
  }

  const LargeVector<Candidate>& candidates_;
  std::map<Cell, std::vector<std::size_t>> kept_;

public:
  std::vector<std::int64_t> displaced_by; ///< -1 for those that are kept
};

/** So many that their conflicts are found in several parts, strays in the last ones. */
TEST(Thinning, IsThatOfItsDefinition)
{
  Random random(7);
  const LargeVector<Candidate> candidates = randomCandidates(320000, random);
  const Thinning thinning = thinOut(candidates, edge);
  const NaiveThinning naive(candidates);
  ASSERT_EQ(thinning.stand_in.size(), candidates.size());
  std::size_t wrong = 0, kept = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const std::int64_t by = naive.displaced_by[c];
    kept += by < 0 ? 1 : 0;
    const auto stand_in = static_cast<std::size_t>(thinning.stand_in[c]);
    wrong += thinning.kept.at(stand_in) != (by < 0 ? c : static_cast<std::size_t>(by));
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(thinning.kept.size(), kept);
  EXPECT_TRUE(std::is_sorted(thinning.kept.begin(), thinning.kept.end()));
  EXPECT_LT(kept, candidates.size() / 2); // there was something to decide
}

} // namespace
} // namespace pcl::acmap::test
