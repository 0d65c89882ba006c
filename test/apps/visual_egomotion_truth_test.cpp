#include "temporary_folder.h"
#include "visual_egomotion_runs.h"

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(EgomotionTruth, ComparesWithTheTruth)
{
  const TemporaryFolder folder;
  const std::string truth = hall().session + "/trajectory.txt";
  const ToolRun run =
      runEgomotion({hall().session, "-o", folder.path("out"), "--truth", truth})
          .succeeded();
  for (const char* word : {"error:", "RPE:", "ATE:"})
    EXPECT_THAT(run.out, HasSubstr(word));
  const nlohmann::json errors = reportOf(folder.path("out")).at("truth");
  EXPECT_EQ(errors.at("pairs"), 5);
  EXPECT_LT(errors.at("translation_per_metre"), 0.03);
  EXPECT_LT(errors.at("rotation_worst"), 0.015);

  // an additional row near the beginning: the trajectory differs
  Trajectory shifted = hall().truth;
  shifted.poses.insert(shifted.poses.begin() + 1, Eigen::Isometry3d::Identity());
  shifted.stamps.push_back(100);
  saveTrajectory(folder.path("shifted.txt"), shifted);
  const ToolRun other = runEgomotion({hall().session,
                                      "-o",
                                      folder.path("other"),
                                      "--truth",
                                      folder.path("shifted.txt")})
                            .succeeded();
  EXPECT_THAT(other.err, HasSubstr("has 7 poses for 6 observations"));
  EXPECT_GT(reportOf(folder.path("other")).at("truth").at("trajectory_error"), 0.1);
}

TEST(EgomotionTruth, NumbersTellWhichTruthIsWhose)
{
  const TemporaryFolder folder;
  const ToolRun run = runEgomotion({observationIn(hall().session, 2),
                                    observationIn(hall().session, 4),
                                    "-o",
                                    folder.path("out"),
                                    "--truth",
                                    hall().session + "/trajectory.txt"})
                          .succeeded();
  EXPECT_THAT(run.err, HasSubstr("has 6 poses for 2 observations; the numbers"));
  EXPECT_LT(reportOf(folder.path("out")).at("truth").at("trajectory_error"), 0.03);
}

TEST(EgomotionTruth, ATruthThatStandsStillHasNoPercentage)
{
  const TemporaryFolder folder;
  Trajectory still = hall().truth;
  for (Eigen::Isometry3d& pose : still.poses)
    pose = still.poses[2];
  saveTrajectory(folder.path("still.txt"), still);
  const ToolRun run = runEgomotion({hall().session,
                                    "-o",
                                    folder.path("out"),
                                    "--truth",
                                    folder.path("still.txt")})
                          .succeeded();
  EXPECT_THAT(run.out, HasSubstr("error:"));
  EXPECT_THAT(run.out, Not(HasSubstr("of the way")));
  const nlohmann::json errors = reportOf(folder.path("out")).at("truth");
  EXPECT_FALSE(errors.contains("translation_per_metre"));
  EXPECT_NEAR(errors.at("translation_rms"), 0.24, 0.03);
}

} // namespace
} // namespace pcl::acmap::test
