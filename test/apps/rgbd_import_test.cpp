#include "json_file.h"
#include "rgbd_folders.h"
#include "run_tool.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class RgbdImport : public testing::Test {
protected:
  ToolRun
  run(const std::vector<std::string>& more = {}, const RunSettings& settings = {}) const
  {
    return runTool(
        ACMAP_RGBD_IMPORT, joined({input_.path(""), "-o", output()}, more), settings);
  }

  std::string
  output() const
  {
    return results_.path("observations");
  }

  std::string
  outputFile(const std::string& name) const
  {
    return output() + "/" + name;
  }

  void
  expectRefused(const ToolRun& run, int exit_code, const std::string& word) const
  {
    test::expectRefused(run, exit_code, word);
    EXPECT_EQ(results_.count(), 0);
  }

  TemporaryFolder input_;
  TemporaryFolder results_;
};

struct ImportedCamera {
  double fx, fy, cx, cy, scale;
};

float
sigmaOf(const PCLPointCloud2& cloud, std::size_t point)
{
  EXPECT_EQ(cloud.fields.back().name, "sigma");
  float sigma = 0;
  std::memcpy(
      &sigma, &cloud.data[point * cloud.point_step + cloud.fields.back().offset], 4);
  return sigma;
}

/** Reads an observation with PCL and compares each pixel with the content of the
 * frame. */
void
expectObservation(const std::string& path, int frame, const ImportedCamera& camera)
{
  SCOPED_TRACE(path);
  PCLPointCloud2 raw;
  ASSERT_EQ(io::loadPCDFile(path, raw), 0);
  ASSERT_EQ(raw.fields.size(), 5u);
  ASSERT_EQ(raw.width, 8u);
  ASSERT_EQ(raw.height, 6u);
  PointCloud<PointXYZRGB> cloud;
  fromPCLPointCloud2(raw, cloud);
  const auto depths = tellingDepths(frame);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const PointXYZRGB& p = cloud[i];
    const double column = static_cast<double>(i % 8);
    const double row = static_cast<double>(i / 8);
    EXPECT_EQ(p.r, 10 + row);
    EXPECT_EQ(p.g, 200 + column);
    EXPECT_EQ(p.b, frame);
    if (i < 2) { // depths 0 and 65535
      EXPECT_TRUE(std::isnan(p.x) && std::isnan(p.y) && std::isnan(p.z));
      EXPECT_TRUE(std::isnan(sigmaOf(raw, i)));
      continue;
    }
    const double z = depths[i] / camera.scale;
    const double x = (column - camera.cx) / camera.fx;
    const double y = (row - camera.cy) / camera.fy;
    EXPECT_FLOAT_EQ(p.z, static_cast<float>(z));
    EXPECT_NEAR(p.x, x * z, 1e-6);
    EXPECT_NEAR(p.y, y * z, 1e-6);
    const double axial = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(sigmaOf(raw, i), axial * std::sqrt(x * x + y * y + 1), 1e-7);
  }
}

void
expectPose(const Eigen::Isometry3d& pose,
           const Eigen::Isometry3d& expected,
           double slack)
{
  EXPECT_LT((pose.translation() - expected.translation()).norm(), slack);
  EXPECT_LT((pose.linear() - expected.linear()).norm(), slack);
}

TEST_F(RgbdImport, SevenScenesComeOutExactly)
{
  writeSevenScenes(input_, 3);
  const ToolRun done = run({"--registered"}).succeeded();
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(done.out, HasSubstr("colour camera: none\n"));
  EXPECT_THAT(done.out, HasSubstr("observations: 3\n"));
  EXPECT_THAT(done.out, HasSubstr("points:      138\n"));
  EXPECT_THAT(done.out, HasSubstr("95.8 %"));
  const Trajectory trajectory = loadTrajectory(outputFile("trajectory.txt"));
  EXPECT_EQ(trajectory.stamps, (std::vector<double>{0, 10, 20}));
  EXPECT_TRUE(trajectory.poses[0].matrix().isIdentity(0));
  for (int frame = 0; frame < 3; ++frame) {
    const auto index = static_cast<std::size_t>(frame);
    const std::string path =
        outputFile("observation_000" + std::to_string(frame) + ".pcd");
    expectObservation(path, frame, {10, 20, 3.5, 2.5, 1000});
    const Eigen::Isometry3d expected = posedAt(0).inverse() * posedAt(frame);
    expectPose(trajectory.poses[index], expected, 1e-12);
    const PointCloudFile file = loadPointCloud(path);
    Eigen::Isometry3d viewpoint(file.sensor_orientation.cast<double>());
    viewpoint.translation() = file.sensor_origin.cast<double>();
    expectPose(viewpoint, expected, 1e-6);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(output()), {}), 4);
}

TEST_F(RgbdImport, TumComesOutExactly)
{
  writeTum(input_, 3);
  const ToolRun done =
      run({"--fx", "10", "--fy", "20", "--cx", "3.5", "--cy", "2.5"}).succeeded();
  EXPECT_EQ(done.err, "");
  const Trajectory trajectory = loadTrajectory(outputFile("trajectory.txt"));
  ASSERT_EQ(trajectory.poses.size(), 3u);
  for (int frame = 0; frame < 3; ++frame) {
    const auto index = static_cast<std::size_t>(frame);
    EXPECT_NEAR(trajectory.stamps[index], 1305031102.1 + 0.1 * frame, 1e-5);
    // stamps in microseconds change the interpolated pose slightly
    expectPose(trajectory.poses[index], posedAt(0).inverse() * posedAt(frame), 1e-5);
    expectObservation(outputFile("observation_000" + std::to_string(frame) + ".pcd"),
                      frame,
                      {10, 20, 3.5, 2.5, 5000});
  }
}

TEST_F(RgbdImport, TumHasADefaultCameraThatIsTold)
{
  writeTum(input_, 1);
  const ToolRun done = run().succeeded();
  EXPECT_THAT(done.err, HasSubstr("warning: the folder does not tell its camera"));
  EXPECT_THAT(done.err, HasSubstr("319.5"));
  EXPECT_THAT(done.err,
              HasSubstr("640 x 480 pixels: scaled to the depth images' 8 x 6"));
  expectObservation(
      outputFile("observation_0000.pcd"), 0, {6.5625, 6.5625, 3.5, 2.5, 5000});
}

TEST_F(RgbdImport, CameraComesFromAFileOfEitherKind)
{
  writeTum(input_, 1);
  TrinocularRig rig;
  rig.width = 8;
  rig.height = 6;
  rig.focal_length = 12;
  rig.center_x = 3;
  rig.center_y = 2;
  saveTrinocularRig(input_.path("rig.yaml"), rig);
  const std::string matrix = input_.write("k.txt", "# camera\n12 0 3\n0 12 2\n0 0 1\n");
  for (const std::string& file : {input_.path("rig.yaml"), matrix}) {
    const ToolRun done =
        run({"--intrinsics", file, "--depth-scale", "2000"}).succeeded();
    EXPECT_EQ(done.err, "");
    expectObservation(outputFile("observation_0000.pcd"), 0, {12, 12, 3, 2, 2000});
    std::filesystem::remove_all(output());
  }
  run({"--intrinsics", matrix, "--fx", "20", "--cy", "4"}).succeeded();
  expectObservation(outputFile("observation_0000.pcd"), 0, {20, 20, 3, 4, 5000});
  std::filesystem::remove_all(output());
  for (const char* bad : {"12 0 3\n0 12 2\n",
                          "12 0 3\n0 12 2\n0 0 nan\n",
                          "x",
                          "",
                          "12 1 3\n0 12 2\n0 0 1\n",
                          "-12 0 3\n0 12 2\n0 0 1\n",
                          "12 0 3 4\n0 12 2\n0 0 1\n",
                          "0 0 3\n0 12 2\n0 0 1\n",
                          "1e-300 0 3\n0 12 2\n0 0 1\n"})
    expectRefused(run({"--intrinsics", input_.write("k.txt", bad)}), 3, "k.txt: ");
  expectRefused(run({"--intrinsics", input_.path("none")}), 3, "none: No such file");
}

TEST_F(RgbdImport, FramesWithoutPoseOrPartnerAreCounted)
{
  writeTum(input_, 4);
  // no pose near frame 0, one pose near frame 1, frame 2 without colour
  const double second = 1305031102.2;
  input_.write("groundtruth.txt",
               poseRow(second + 0.015, posedAt(1)) +
                   poseRow(second + 0.2 - 0.01, posedAt(3)));
  std::string colors = contentOf(input_.path("rgb.txt"));
  input_.write("rgb.txt",
               colors.replace(colors.find("1305031102.304"), 14, "1305031102.35"));
  const ToolRun done =
      run({"--intrinsics", input_.write("k", "9 0 4\n0 9 3\n0 0 1")}).succeeded();
  EXPECT_THAT(done.err, HasSubstr("1 depth images left out"));
  EXPECT_THAT(done.err, HasSubstr("1 frames left out: no pose"));
  const Trajectory trajectory = loadTrajectory(outputFile("trajectory.txt"));
  ASSERT_EQ(trajectory.poses.size(), 2u);
  expectPose(trajectory.poses[1], posedAt(1).inverse() * posedAt(3), 1e-12);
  expectObservation(outputFile("observation_0000.pcd"), 1, {9, 9, 4, 3, 5000});
  expectObservation(outputFile("observation_0001.pcd"), 3, {9, 9, 4, 3, 5000});
}

TEST_F(RgbdImport, GapIsTheUsers)
{
  writeTum(input_, 2);
  EXPECT_EQ(run({"--max-stamp-gap", "0.003"}).exit_code, 4); // colour is 4 ms later
  EXPECT_EQ(run({"--max-stamp-gap", "0.005"}).exit_code, 4); // poses are 10 ms away
  EXPECT_EQ(run({"--max-stamp-gap", "0.005", "--no-poses"}).exit_code, 0);
}

TEST_F(RgbdImport, WithoutPosesNoneIsAskedForOrWritten)
{
  writeSevenScenes(input_, 2);
  std::filesystem::remove(input_.path("frame-000000.pose.txt"));
  input_.write("frame-000010.pose.txt", "lost");
  run({"--no-poses"}).succeeded();
  EXPECT_FALSE(std::filesystem::exists(outputFile("trajectory.txt")));
  const PointCloudFile file = loadPointCloud(outputFile("observation_0001.pcd"));
  EXPECT_EQ(file.sensor_origin, Eigen::Vector3f::Zero());
  EXPECT_TRUE(file.sensor_orientation.isApprox(Eigen::Quaternionf::Identity(), 0));
}

TEST_F(RgbdImport, EveryAndMaximumDepthThin)
{
  writeSevenScenes(input_, 5);
  const ToolRun done = run({"--every", "2", "-max_depth", "1.2"}).succeeded();
  EXPECT_EQ(loadTrajectory(outputFile("trajectory.txt")).stamps,
            (std::vector<double>{0, 20, 40}));
  EXPECT_THAT(done.out, HasSubstr("points:      19\n")); // 1.02 to 1.2 m
  EXPECT_THAT(done.out, HasSubstr("median depth: 1.11 m"));
  EXPECT_THAT(done.err, HasSubstr("2 observations have no point at all"));
}

TEST_F(RgbdImport, ReportHasTheCounts)
{
  writeSevenScenes(input_, 2);
  const std::string path = input_.path("report.json");
  run({"--report", path}).succeeded();
  const auto report = jsonOfFile(path);
  EXPECT_EQ(report["tool"], "pcl_rgbd_import");
  EXPECT_EQ(report["layout"], "7-Scenes");
  EXPECT_EQ(report["observations"], 2);
  EXPECT_EQ(report["points"], 92);
  EXPECT_NEAR(report["finite_share"].get<double>(), 92.0 / 96, 1e-12);
  EXPECT_NEAR(report["median_depth"].get<double>(), 1.47, 1e-12);
  EXPECT_GE(report["seconds"]["import"], 0.0);
}

TEST_F(RgbdImport, HelpTellsUnitsAndCodes)
{
  const ToolRun help = runTool(ACMAP_RGBD_IMPORT, {"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"metre", "--skip-broken", "7-Scenes", "TUM", "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
}

TEST_F(RgbdImport, UsageErrorsAreRefused)
{
  writeSevenScenes(input_, 1);
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"--every", "0"},
                                             {"--every", "-1"},
                                             {"--fx", "0"},
                                             {"--fx", "1e-300"},
                                             {"--depth-scale", "1e300"},
                                             {"--fx", "nan"},
                                             {"--fy", "500"},
                                             {"--depth-scale", "inf"},
                                             {"--max-depth", "-1"},
                                             {"--max-stamp-gap", "x"},
                                             {"--registered", "--color-camera", "c"},
                                             {"stray"},
                                             {"--threads", "2"}})
    expectRefused(run(words), 2, "--help");
  expectRefused(runTool(ACMAP_RGBD_IMPORT, {input_.path("")}), 2, "--output");
  expectRefused(runTool(ACMAP_RGBD_IMPORT, {input_.path(""), "-o", input_.path(".")}),
                2,
                "input");
}

TEST_F(RgbdImport, OutputsAppearTogetherOrNotAtAll)
{
  writeSevenScenes(input_, 3);
  RunSettings full;
  full.file_size_limit = 500;
  expectRefused(run({}, full), 5, "observation_0000.pcd");
  run().succeeded();
  const std::string before = contentOf(outputFile("observation_0000.pcd"));
  const ToolRun again = run({"--max-depth", "1.1"});
  EXPECT_EQ(again.exit_code, 5);
  EXPECT_THAT(again.err, HasSubstr("already holds observation_0000.pcd"));
  EXPECT_EQ(contentOf(outputFile("observation_0000.pcd")), before);
}

} // namespace
} // namespace pcl::acmap::test
