#include "temporary_folder.h"
#include "visual_egomotion_runs.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/** Checks the observations with a pose; their stamps are indices in the sequence.
 * \return number of them after the gap */
std::size_t
expectRightOrLost(const std::string& output, const Trajectory& truth, std::size_t gap)
{
  const Trajectory found = loadTrajectory(output + "/trajectory.txt");
  const Eigen::Isometry3d T_map_world = truth.poses[0].inverse();
  std::size_t behind = 0;
  for (std::size_t i = 0; i < found.poses.size(); ++i) {
    const auto place = static_cast<std::size_t>(
        std::find(truth.stamps.begin(), truth.stamps.end(), found.stamps[i]) -
        truth.stamps.begin());
    behind += place > gap ? 1 : 0;
    const Eigen::Isometry3d error =
        (T_map_world * truth.poses[place]).inverse() * found.poses[i];
    EXPECT_LT(error.translation().norm(), 0.06) << place;
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.03) << place;
  }
  return behind;
}

void
darken(const std::string& session, std::size_t first, std::size_t last)
{
  for (std::size_t i = first; i <= last; ++i)
    change(observationIn(session, i), blacken);
}

constexpr const char* straight = "{from: [0, 0, 0], to: [0, 0, 1.08], views: 10, yaw: "
                                 "[0, 0, 0, 0, 0, 0, 0, 0, 0, 0]}";

TEST(EgomotionGaps, ThreeDarkViewsLeaveTheRestRightOrLost)
{
  for (const char* line : {straight,
                           "{from: [0, 0, 0], to: [0.4, 0, 1.8], views: 10, "
                           "yaw: [0, 3, 6, 9, 12, 15, 18, 21, 24, 27]}",
                           "{from: [0, 0, 0], to: [0, 0, 1.8], views: 10, "
                           "yaw: [0, 0, 0, 0, 10, 20, 40, 60, 60, 60]}"}) {
    const TemporaryFolder folder;
    const Hall session = walk(folder, line);
    darken(session.session, 4, 6);
    const ToolRun run =
        runEgomotion({session.session, "-o", folder.path("out")}).succeeded();
    const std::size_t behind = expectRightOrLost(folder.path("out"), session.truth, 6);
    if (line == straight) {
      EXPECT_EQ(behind, 3U);
      EXPECT_THAT(run.err, HasSubstr("observation_0003.pcd, past 3 others"));
    }
  }
}

TEST(EgomotionGaps, ReachGrowsUpToThreeSteps)
{
  const TemporaryFolder folder;
  const Hall session = walk(folder, straight);
  const auto posedWith = [&](const std::string& output, const char* reach) {
    const ToolRun run = runEgomotion(
        {session.session, "-o", folder.path(output), "--max-translation", reach});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return loadTrajectory(folder.path(output + "/trajectory.txt")).poses.size();
  };
  darken(session.session, 3, 4); // three steps of 0.12 m
  EXPECT_EQ(posedWith("near", "0.15"), 8U);
  darken(session.session, 5, 6); // five steps
  EXPECT_EQ(posedWith("far", "0.15"), 3U);
  EXPECT_EQ(posedWith("wide", "1"), 6U);
}

TEST(EgomotionGaps, ALostEndIsTold)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  darken(session, 5, 5);
  EXPECT_THAT(runEgomotion({session, "-o", folder.path("one")}).err,
              Not(HasSubstr("nothing was joined")));
  darken(session, 4, 4);
  EXPECT_THAT(runEgomotion({session, "-o", folder.path("two")}).err,
              HasSubstr("nothing was joined from " + observationIn(session, 4) +
                        " on: the last 2 observations are lost"));
}

} // namespace
} // namespace pcl::acmap::test
