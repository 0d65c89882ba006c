#include "motion/odometry_run.h"

#include <gmock/gmock.h>

#include <set>
#include <utility>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/** A chain along x with one observation per metre, some of whose pairs cannot be
 * estimated. */
class ChainOfPairs {
public:
  explicit ChainOfPairs(std::set<std::pair<std::size_t, std::size_t>> failing)
  : failing_(std::move(failing))
  {}

  void
  run(std::size_t observations)
  {
    PoseChain chain(
        [this](const OdometryView& now, const OdometryView& before) {
          return motion(now.index, before.index);
        },
        [this](const OdometryView& view, const Eigen::Isometry3d& T_map_camera) {
          places.emplace_back(view.index, T_map_camera.translation().x());
        });
    for (std::size_t i = 0; i < observations; ++i) {
      OdometryView view;
      view.index = i;
      chain.add(view);
    }
  }

  /** \brief In the order in which they were kept. */
  std::vector<std::pair<std::size_t, double>> places;
  std::vector<std::pair<std::size_t, std::size_t>> tried;

private:
  std::optional<Eigen::Isometry3d>
  motion(std::size_t now, std::size_t before)
  {
    tried.emplace_back(now, before);
    if (failing_.count({now, before}) > 0)
      return std::nullopt;
    Eigen::Isometry3d T_before_now = Eigen::Isometry3d::Identity();
    T_before_now.translation().x() = static_cast<double>(now - before);
    return T_before_now;
  }

  std::set<std::pair<std::size_t, std::size_t>> failing_;
};

TEST(PoseChain, JoinsEachToTheOneBefore)
{
  ChainOfPairs chain({});
  chain.run(4);
  EXPECT_THAT(chain.places,
              ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 2), Pair(3, 3)));
  EXPECT_THAT(chain.tried, ElementsAre(Pair(1, 0), Pair(2, 1), Pair(3, 2)));
}

TEST(PoseChain, TriesTheTwoPosedOnesBeforeThat)
{
  ChainOfPairs chain({{4, 3}, {4, 2}});
  chain.run(5);
  EXPECT_THAT(chain.places.back(), Pair(4, 4));
  EXPECT_THAT(chain.tried.back(), Pair(4, 1));
  ChainOfPairs lost({{4, 3}, {4, 2}, {4, 1}});
  lost.run(6);
  // three failures, then the next view is tried against the last three posed ones
  EXPECT_THAT(lost.places,
              ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 2), Pair(3, 3), Pair(5, 5)));
  EXPECT_EQ(lost.tried.size(), 7U);
  EXPECT_THAT(lost.tried.back(), Pair(5, 3));
}

TEST(PoseChain, BeginsWithTheFirstThatAnotherIsJoinedTo)
{
  ChainOfPairs chain({{1, 0}, {2, 1}, {2, 0}});
  chain.run(5);
  EXPECT_THAT(chain.places, ElementsAre(Pair(2, 0), Pair(3, 1), Pair(4, 2)));
  ChainOfPairs bridged({{1, 0}, {2, 1}});
  bridged.run(4);
  EXPECT_THAT(bridged.places, ElementsAre(Pair(0, 0), Pair(2, 2), Pair(3, 3)));
}

TEST(PoseChain, WithoutAMotionNothingIsKept)
{
  ChainOfPairs chain({{1, 0}, {2, 1}, {2, 0}});
  chain.run(3);
  EXPECT_THAT(chain.places, IsEmpty());
}

} // namespace
} // namespace pcl::acmap::test
