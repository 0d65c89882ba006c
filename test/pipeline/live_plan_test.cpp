#include <pcl/pipeline/live_plan.h>
#include <pcl/pipeline/session_pace.h>

#include <gmock/gmock.h>

#include <chrono>

namespace pcl::acmap::test {
namespace {

using testing::EndsWith;

std::optional<Eigen::Isometry3d>
poseAt(double x, double z)
{
  return Eigen::Isometry3d(Eigen::Translation3d(x, 0, z));
}

TEST(LivePlan, TellsObservationsAndWhatToDo)
{
  LivePlan plan;
  MappingState state;
  state.processed = 1;
  state.poses = {poseAt(0, 0)};
  plan.update(state);
  EXPECT_EQ(plan.status(), "1 observation");
  state.processed = 2;
  state.lag = 5;
  plan.update(state);
  EXPECT_EQ(plan.status(), "2 observations, move slower");
  state.poses.push_back(std::nullopt);
  plan.update(state);
  EXPECT_THAT(plan.status(), EndsWith("lost: go back to what was seen before"));
}

TEST(LivePlan, HasTheWayAndWhatTheCameraSees)
{
  LivePlan plan;
  MappingState state;
  state.poses = {poseAt(0, 0), std::nullopt, poseAt(0, 3)};
  plan.update(state);
  ASSERT_EQ(plan.strokes().size(), 2U);
  const PlanStroke& way = plan.strokes()[0];
  const PlanStroke& sight = plan.strokes()[1];
  ASSERT_EQ(way.points.size(), 2U) << "lost ones have no place";
  EXPECT_FALSE(way.is_area);
  EXPECT_NEAR((way.points[1] - way.points[0]).norm(), 3, 1e-9);
  ASSERT_EQ(sight.points.size(), 3U);
  EXPECT_TRUE(sight.is_area);
  EXPECT_LT((sight.points[0] - way.points[1]).norm(), 1e-9);
  const Eigen::Vector2d ahead = 0.5 * (sight.points[1] + sight.points[2]);
  EXPECT_GT((ahead - way.points[1]).dot(way.points[1] - way.points[0]), 0);
  state.poses.push_back(std::nullopt);
  plan.update(state);
  EXPECT_EQ(plan.strokes().size(), 1U) << "nothing is seen of a lost one";
}

TEST(SessionPace, WaitsAsLongAsTheCameraDid)
{
  using Clock = std::chrono::steady_clock;
  int calls = 0;
  SessionPace pace([&] { ++calls; });
  TrinocularFrame frame;
  frame.stamp = 5000000;
  const Clock::time_point begin = Clock::now();
  pace(frame);
  EXPECT_EQ(calls, 0) << "the first one is due at once";
  frame.stamp += 250000;
  pace(frame);
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(250));
  EXPECT_GE(calls, 2);
  frame.stamp = 0; // the clock of the camera was set
  pace(frame);
}

TEST(SessionPace, IsEndedByWhatItCalls)
{
  SessionPace pace([] { throw std::runtime_error("stopped"); });
  TrinocularFrame frame;
  frame.stamp = 1;
  pace(frame);
  frame.stamp = 30000000;
  EXPECT_THROW(pace(frame), std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
