#include "temporary_folder.h"
#include "visual_egomotion_runs.h"

#include <pcl/core/image_file.h>
#include <pcl/core/planar_pose.h>
#include <pcl/io/pcd_io.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::set<std::string>
outputsOf(const std::vector<std::size_t>& observations)
{
  std::set<std::string> names = {"trajectory.txt", "report.json", "plan.png"};
  for (const std::size_t i : observations)
    names.insert("observation_000" + std::to_string(i) + ".pcd");
  return names;
}

/** Checks that the rows are the poses of these observations of the hall, in the frame
 * of the first of them. */
void
expectPoses(const std::string& output, const std::vector<std::size_t>& observations)
{
  const Trajectory found = loadTrajectory(output + "/trajectory.txt");
  const Trajectory& truth = hall().truth;
  ASSERT_EQ(found.poses.size(), observations.size());
  EXPECT_TRUE(found.poses[0].isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  const Eigen::Isometry3d T_map_world = truth.poses[observations[0]].inverse();
  for (std::size_t i = 0; i < observations.size(); ++i) {
    EXPECT_EQ(found.stamps[i], truth.stamps[observations[i]]);
    const Eigen::Isometry3d error =
        (T_map_world * truth.poses[observations[i]]).inverse() * found.poses[i];
    // between neighbours it moves by 0.24 m and rotates by 0.07 rad
    EXPECT_LT(error.translation().norm(), 0.03) << i;
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.015) << i;
  }
}

/** Reads the VIEWPOINT with PCL, as a user's own program would. */
Eigen::Isometry3d
viewpointOf(const std::string& pcd, PCLPointCloud2& cloud)
{
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  EXPECT_EQ(PCDReader().read(pcd, cloud, origin, orientation, version), 0);
  Eigen::Isometry3d pose(orientation.cast<double>());
  pose.translation() = origin.head<3>().cast<double>();
  return pose;
}

TEST(EgomotionTool, TellsThePosesOfASequence)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out put");
  const ToolRun run = runEgomotion({hall().session, "-o", output}).succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("posed:       6 of 6 observations"));
  EXPECT_EQ(filesIn(output), outputsOf({0, 1, 2, 3, 4, 5}));
  expectPoses(output, {0, 1, 2, 3, 4, 5});
  const nlohmann::json report = reportOf(output);
  EXPECT_EQ(report.at("posed"), 6);
  EXPECT_EQ(report.at("mode"), "accurate");
  EXPECT_TRUE(report.at("lost").empty());
  ASSERT_EQ(report.at("pairs").size(), 5U);
  for (const nlohmann::json& pair : report.at("pairs")) {
    EXPECT_EQ(pair.at("outcome"), "estimated");
    EXPECT_GE(pair.at("matches"), pair.at("inliers"));
    EXPECT_GT(pair.at("inliers"), 5);
    EXPECT_GT(pair.at("standard_deviations").at("about_y"), 0);
    EXPECT_NEAR(pair.at("action").at("dz"), 0.24, 0.05);
  }
}

TEST(EgomotionTool, PaperModeIsOneFitPerPair)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out");
  for (const char* departure : {"--keypoints", "--max-translation", "--max-rotation"})
    EXPECT_EQ(runEgomotion({hall().session, "-o", output, "--paper", departure, "20"})
                  .exit_code,
              2);
  runEgomotion({hall().session, "-o", output, "--paper"}).succeeded();
  const nlohmann::json report = reportOf(output);
  EXPECT_EQ(report.at("mode"), "paper");
  EXPECT_EQ(report.at("refinement"), false);
  ASSERT_EQ(report.at("pairs").size(), 5U);
  for (const nlohmann::json& pair : report.at("pairs")) {
    EXPECT_EQ(pair.at("outcome"), "estimated");
    EXPECT_EQ(pair.at("fits"), 1);
    EXPECT_GT(pair.at("iterations"), 0);
    EXPECT_EQ(pair.at("removed").get<int>() + pair.at("inliers").get<int>(),
              pair.at("matches"));
    EXPECT_EQ(pair.at("is_refined"), false);
    EXPECT_NEAR(pair.at("action").at("dz"), 0.24, 0.1);
  }
}

TEST(EgomotionTool, ObservationsAreAsTheyWereButForThePose)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out");
  runEgomotion({hall().session, "-o", output, "--6dof"}).succeeded();
  expectPoses(output, {0, 1, 2, 3, 4, 5});
  const Trajectory found = loadTrajectory(output + "/trajectory.txt");
  for (std::size_t i = 0; i < 6; ++i) {
    PCLPointCloud2 before, after;
    viewpointOf(observationIn(hall().session, i), before);
    const Eigen::Isometry3d pose = viewpointOf(observationIn(output, i), after);
    EXPECT_EQ(before.data, after.data);
    EXPECT_EQ(before.height, after.height);
    EXPECT_TRUE(pose.isApprox(found.poses[i], 1e-5));
  }
}

/** The camera tilts up, as a hand-held one may; a robot on a floor cannot. */
TEST(EgomotionTool, ACameraThatLeavesTheFloorIsFollowed)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  constexpr float step = 0.05F; // radians
  for (std::size_t i = 0; i < 6; ++i)
    change(observationIn(session, i), [&](PCLPointCloud2& cloud) {
      const float angle = step * static_cast<float>(i);
      turn(cloud, Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitX()));
    });
  const ToolRun run = runEgomotion({session, "-o", folder.path("found")});
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("path:        in space, 0.89 (tilts by 2.8"))
      << "of 0.05 radians";
  EXPECT_THAT(run.out, HasSubstr("; --no-6dof states a planar one"));
  EXPECT_THAT(run.out, HasSubstr("posed:       6 of 6 observations"));
  EXPECT_EQ(reportOf(folder.path("found")).at("path").at("is_in_space"), true);

  runEgomotion({session, "-o", folder.path("free"), "--6dof"}).succeeded();
  EXPECT_EQ(contentOf(folder.path("found/trajectory.txt")),
            contentOf(folder.path("free/trajectory.txt")));

  const ToolRun planar =
      runEgomotion({session, "-o", folder.path("planar"), "--no-6dof"});
  EXPECT_THAT(planar.out, Not(HasSubstr("path:")));
}

TEST(EgomotionTool, ARobotStaysOnTheFloor)
{
  const TemporaryFolder folder;
  const ToolRun run =
      runEgomotion({hall().session, "-o", folder.path("found")}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("path:        planar, 0."));
  EXPECT_THAT(run.out, HasSubstr("; --6dof states one in space"));
  runEgomotion({hall().session, "-o", folder.path("planar"), "--no-6dof"}).succeeded();
  EXPECT_EQ(contentOf(folder.path("found/trajectory.txt")),
            contentOf(folder.path("planar/trajectory.txt")));
}

TEST(EgomotionTool, LostObservationsLeaveAGap)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  change(observationIn(session, 2), blacken);
  change(observationIn(session, 3), takePlaces);
  const std::string output = folder.path("out");
  const ToolRun run = runEgomotion({session, "-o", output}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("4 of 6 observations"));
  EXPECT_EQ(run.errorLines(), 3U) << run.err;
  const nlohmann::json report = reportOf(output), lost = report.at("lost");
  ASSERT_EQ(lost.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string reason = lost[i].at("reason");
    EXPECT_EQ(lost[i].at("observation"), observationIn(session, i + 2));
    EXPECT_GT(reason.size(), 30U);
    EXPECT_THAT(run.err,
                HasSubstr("lost: " + observationIn(session, i + 2) + ": " + reason));
  }
  EXPECT_EQ(filesIn(output), outputsOf({0, 1, 4, 5}));
  expectPoses(output, {0, 1, 4, 5});
  const nlohmann::json& join = *std::prev(report.at("pairs").end(), 2);
  EXPECT_EQ(join.at("skipped"), 2);
  EXPECT_THAT(run.err,
              HasSubstr("was joined to observation_0001.pcd, past 2 others, by " +
                        join.at("inliers").dump() + " matches"));
  EXPECT_EQ(report.at("pairs").back().at("skipped"), 0);
  // as a separate sequence it is complete
  const ToolRun again = runEgomotion({output, "-o", folder.path("again")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  expectPoses(folder.path("again"), {0, 1, 4, 5});
}

TEST(EgomotionTool, WhatItWritesGoesIntoRectification)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  change(observationIn(session, 1), blacken);
  runEgomotion({session, "-o", folder.path("posed")}).succeeded();
  const ToolRun run = runTool(ACMAP_ENTROPY_RECTIFICATION,
                              {folder.path("posed"), "-o", folder.path("straight")})
                          .succeeded();
  EXPECT_THAT(run.err, Not(HasSubstr("VIEWPOINT")));
  EXPECT_EQ(loadTrajectory(folder.path("straight/trajectory.txt")).stamps,
            loadTrajectory(folder.path("posed/trajectory.txt")).stamps);
}

TEST(EgomotionTool, ABadFirstObservationDoesNotSpoilTheRest)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  change(observationIn(session, 0), blacken);
  const std::string output = folder.path("out");
  const ToolRun run = runEgomotion({session, "-o", output}).succeeded();
  EXPECT_THAT(run.err,
              HasSubstr("lost: " + observationIn(session, 0) +
                        ": with observation_0001.pcd: observation_0000.pcd shows"));
  EXPECT_EQ(reportOf(output).at("pairs").at(0).at("reason"),
            "observation_0000.pcd shows nothing to recognise");
  expectPoses(output, {1, 2, 3, 4, 5});
}

TEST(EgomotionTool, NothingIsWrittenWhenAllAreLost)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  for (std::size_t i = 1; i < 6; ++i)
    change(observationIn(session, i), blacken);
  const ToolRun run = runEgomotion({session, "-o", folder.path("out")});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(run.errorLines(), 1U);
  EXPECT_THAT(run.err, HasSubstr("observation_0001.pcd"));
  EXPECT_FALSE(fs::exists(folder.path("out")));
}

TEST(EgomotionTool, FilesInTheOrderOfTheCommandLine)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  fs::rename(observationIn(session, 0), session + "/a first one.pcd");
  fs::rename(observationIn(session, 1), session + "/b.PCD");
  const std::vector<std::string> files = {session + "/a first one.pcd",
                                          session + "/b.PCD"};
  const ToolRun run =
      runEgomotion({files[0], files[1], "-o", folder.path("out")}).succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(fs::exists(folder.path("out/a first one.pcd")));
  const Trajectory found = loadTrajectory(folder.path("out/trajectory.txt"));
  EXPECT_THAT(found.stamps, ElementsAre(0, 1));

  // sorted in a folder, they would have the opposite order
  const ToolRun back =
      runEgomotion({files[1], files[0], "-o", folder.path("back")}).succeeded();
  EXPECT_THAT(back.err, HasSubstr("named anew"));
  EXPECT_EQ(filesIn(folder.path("back")), outputsOf({0, 1}));
  EXPECT_EQ(loadPointCloud(folder.path("back/observation_0000.pcd")).cloud.data,
            loadPointCloud(files[1]).cloud.data);
  const Trajectory backwards = loadTrajectory(folder.path("back/trajectory.txt"));
  const Eigen::Isometry3d there_and_back = found.poses[1] * backwards.poses[1];
  EXPECT_LT(there_and_back.translation().norm(), 0.01);
}

std::size_t
countOf(const RgbImage& image, int top, int bottom, bool (*is_it)(const std::uint8_t*))
{
  std::size_t count = 0;
  for (int row = top; row < bottom; ++row)
    for (int column = 0; column < image.width; ++column)
      count += is_it(image.at(column, row)) ? 1 : 0;
  return count;
}

bool
isReddish(const std::uint8_t* pixel)
{
  return pixel[0] > pixel[1] + 60;
}

bool
isGreenish(const std::uint8_t* pixel)
{
  return pixel[1] > pixel[0] + 60;
}

TEST(EgomotionTool, PicturesShowMatchesBeforeAndAfterRejection)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  change(observationIn(session, 3), blacken);
  const std::string output = folder.path("out");
  runEgomotion({session, "-o", output, "--pictures"}).succeeded();
  for (const int i : {1, 2, 3, 4, 5}) {
    const RgbImage image =
        loadRgbImage(output + "/matches_000" + std::to_string(i) + ".png");
    EXPECT_GE(image.width, 2 * 160);
    EXPECT_GE(image.height, 2 * 120);
    const int middle = image.height / 2;
    EXPECT_EQ(countOf(image, 0, middle, isGreenish), 0U);
    EXPECT_EQ(countOf(image, middle, image.height, isReddish), 0U);
    EXPECT_EQ(countOf(image, 0, middle, isReddish) > 1000, i != 3);
    EXPECT_EQ(countOf(image, middle, image.height, isGreenish) > 1000, i != 3);
  }
  // the lost one is a red gap in the blue trajectory
  const RgbImage plan = loadRgbImage(output + "/plan.png");
  EXPECT_GT(countOf(plan, 0, plan.height, isReddish), 100U);
}

TEST(EgomotionTool, LengthsInOtherUnitsAreScaled)
{
  const TemporaryFolder folder;
  const std::string session = copyOfHall(folder.path("session"));
  fs::remove(session + "/trajectory.txt");
  for (std::size_t i = 0; i < 6; ++i)
    change(observationIn(session, i), [](PCLPointCloud2& cloud) {
      PointCloud<PointXYZ> points;
      fromPCLPointCloud2(cloud, points);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector3f in_mm = 1000 * points[k].getVector3fMap();
        std::memcpy(&cloud.data[k * cloud.point_step], in_mm.data(), sizeof in_mm);
      }
      dropField(cloud, "sigma"); // clouds without sigma are accepted
    });
  const std::string output = folder.path("out");
  const ToolRun unscaled = runEgomotion({session, "-o", folder.path("unscaled")});
  EXPECT_THAT(unscaled.err, HasSubstr("millimetres"));
  Trajectory truth = hall().truth;
  for (Eigen::Isometry3d& pose : truth.poses)
    pose.translation() *= 1000;
  saveTrajectory(folder.path("truth.txt"), truth);
  const ToolRun run = runEgomotion({session,
                                    "-o",
                                    output,
                                    "--scale",
                                    "0.001",
                                    "--truth",
                                    folder.path("truth.txt")})
                          .succeeded();
  EXPECT_LT(reportOf(output).at("truth").at("translation_per_metre"), 0.03);
  EXPECT_EQ(run.err, "");
  PCLPointCloud2 before, after;
  viewpointOf(observationIn(hall().session, 5), before);
  const Eigen::Isometry3d pose = viewpointOf(observationIn(output, 5), after);
  EXPECT_NEAR(
      pose.translation().norm(), hall().truth.poses[5].translation().norm(), 0.05);
  PointCloud<PointXYZ> points, scaled;
  fromPCLPointCloud2(before, points);
  fromPCLPointCloud2(after, scaled);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].getVector3fMap().allFinite()) {
      ASSERT_TRUE(
          scaled[k].getVector3fMap().isApprox(points[k].getVector3fMap(), 1e-5));
    }
}

TEST(EgomotionTool, OptionsReachTheEstimate)
{
  const TemporaryFolder folder;
  runEgomotion({hall().session,
                "-o",
                folder.path("out"),
                "--keypoints",
                "90",
                "--no-refinement"})
      .succeeded();
  const nlohmann::json report = reportOf(folder.path("out"));
  ASSERT_EQ(report.at("pairs").size(), 5U);
  for (const nlohmann::json& pair : report.at("pairs")) {
    EXPECT_LE(pair.at("keypoints"), 3 * 90);
    EXPECT_EQ(pair.at("is_refined"), false);
    EXPECT_FALSE(pair.contains("motion"));
  }
  // the camera moves by 0.24 m per pair, and rotates by 4 degrees
  for (const auto& [option, limit] :
       {std::pair{"--max-translation", "0.02"}, {"--max-rotation", "1"}})
    EXPECT_EQ(runEgomotion({observationIn(hall().session, 0),
                            observationIn(hall().session, 1),
                            "-o",
                            folder.path("near"),
                            option,
                            limit})
                  .exit_code,
              4)
        << option;
}

} // namespace
} // namespace pcl::acmap::test
