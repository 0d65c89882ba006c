#include "json_file.h"
#include "rgbd_folders.h"
#include "run_tool.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/core/trajectory.h>
#include <pcl/io/pcd_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

using Cloud = PointCloud<PointXYZRGBSigma>;

/** More pixels than the depth images have, but of a coarser resolution: some show
 * several points. */
constexpr std::int32_t color_width = 12;
constexpr std::int32_t color_height = 9;
constexpr double color_fx = 7, color_fy = 13, color_cx = 6, color_cy = 3.5;

/** A pose for which any confusion of axes or signs is detected. */
Eigen::Isometry3d
depthFromColor()
{
  Eigen::Isometry3d pose(
      Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, -2, 0.5).normalized()));
  pose.translation() = Eigen::Vector3d(0.05, -0.02, 0.03);
  return pose;
}

std::string
listText(const Eigen::RowVector3d& numbers)
{
  const Eigen::IOFormat list(
      Eigen::FullPrecision, Eigen::DontAlignCols, ", ", "\n", "", "", "[", "]");
  std::ostringstream text;
  text << numbers.format(list);
  return text.str();
}

std::string
colorCameraText(const Eigen::Isometry3d& T_depth_color = depthFromColor())
{
  const Eigen::Matrix3d turn = T_depth_color.linear();
  return "focal_length_x: 7\nfocal_length_y: 13\ncenter_x: 6\ncenter_y: 3.5\n"
         "position: " +
         listText(T_depth_color.translation().transpose()) + "\nrotation: [" +
         listText(turn.row(0)) + ", " + listText(turn.row(1)) + ", " +
         listText(turn.row(2)) + "]\n";
}

/** Depths in mixed order: in some pixels the nearest point comes first, in others
 * last. */
std::vector<std::uint16_t>
mixedDepths(int frame)
{
  std::vector<std::uint16_t> depths = tellingDepths(frame);
  for (std::size_t i = 2; i < depths.size(); ++i)
    depths[i] = static_cast<std::uint16_t>(1000 + 37 * i * i % 101 * 10 + 500 * frame);
  return depths;
}

class RgbdRegistration : public testing::Test {
protected:
  ToolRun
  run(const std::vector<std::string>& more = {}) const
  {
    return runTool(ACMAP_RGBD_IMPORT, joined({input_.path(""), "-o", output_}, more));
  }

  ToolRun
  runWith(const std::string& color_camera) const
  {
    return run({"--color-camera", settings_.write("color.yaml", color_camera)});
  }

  void
  expectRefused(const ToolRun& run, int exit_code, const std::string& word) const
  {
    test::expectRefused(run, exit_code, word);
    EXPECT_EQ(results_.count(), 0);
  }

  /** Depths of 8 x 6 pixels beside colours of 12 x 9. */
  void
  writeTwoCameras(int frames)
  {
    writeSevenScenes(input_, frames);
    for (int frame = 0; frame < frames; ++frame) {
      const std::string name = "frame-0000" + std::to_string(frame) + "0";
      const RgbImage colors = tellingColors(frame, color_width, color_height);
      input_.write(name + ".color.png", textOfBytes(encodePng(colors)));
      input_.write(name + ".depth.png", depthPngBytes(8, 6, mixedDepths(frame)));
    }
  }

  /** One depth, the others unknown, in images of a Kinect's size. */
  void
  writeKinect(int column, int row, std::uint16_t depth)
  {
    constexpr std::uint32_t width = 640, height = 480;
    std::vector<std::uint16_t> depths(std::size_t{width} * height);
    depths[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] =
        depth;
    RgbImage colors{width, height, {}};
    colors.values.resize(3 * depths.size(), 7);
    input_.write("frame-000000.color.png", textOfBytes(encodePng(colors)));
    input_.write("frame-000000.depth.png", depthPngBytes(width, height, depths));
    input_.write("frame-000000.pose.txt", matrixText(posedAt(0).matrix()));
    input_.write("camera-intrinsics.txt", "5.85e+02 0 320\n0 585 240\n0 0 1\n");
  }

  Cloud
  observation(int index) const
  {
    Cloud cloud;
    const std::string name = "/observation_000" + std::to_string(index) + ".pcd";
    EXPECT_EQ(io::loadPCDFile(output_ + name, cloud), 0);
    return cloud;
  }

  /** The only point of an observation, as column and row. */
  std::pair<int, int>
  onlyPixel(const Cloud& cloud) const
  {
    std::vector<int> found;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (cloud[i].z > 0)
        found.push_back(static_cast<int>(i));
    EXPECT_EQ(found.size(), 1u);
    const int pixel = found.empty() ? -1 : found.front();
    return {pixel % 640, pixel / 640};
  }

  TemporaryFolder input_;
  TemporaryFolder settings_;
  TemporaryFolder results_;
  std::string output_ = results_.path("observations");
};

/** A measurement of the depth camera of the generated folders. */
struct Measured {
  Eigen::Vector3d point; ///< metres, in the colour camera's frame
  double sigma;
  int column, row; ///< its pixel in the colour image
};

std::vector<Measured>
measuredIn(const std::vector<std::uint16_t>& depths)
{
  std::vector<Measured> all;
  for (std::size_t i = 2; i < depths.size(); ++i) { // without 0 and 65535
    const double z = depths[i] / 1000.0;
    const Eigen::Vector3d ray((static_cast<double>(i % 8) - 3.5) / 10,
                              (static_cast<double>(i / 8) - 2.5) / 20,
                              1);
    const Eigen::Vector3d p = depthFromColor().inverse() * (z * ray);
    const double axial = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    all.push_back({p,
                   axial * ray.norm(),
                   static_cast<int>(std::lround(color_fx * p.x() / p.z() + color_cx)),
                   static_cast<int>(std::lround(color_fy * p.y() / p.z() + color_cy))});
  }
  return all;
}

TEST_F(RgbdRegistration, PixelsHoldTheNearestPointTheyShow)
{
  writeTwoCameras(2);
  const ToolRun done = runWith(colorCameraText()).succeeded();
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(done.out, HasSubstr("color.yaml\n"));
  int hidden = 0, holes = 0;
  for (int frame = 0; frame < 2; ++frame) {
    const Cloud cloud = observation(frame);
    ASSERT_EQ(cloud.width, static_cast<std::uint32_t>(color_width));
    ASSERT_EQ(cloud.height, static_cast<std::uint32_t>(color_height));
    const std::vector<Measured> measured = measuredIn(mixedDepths(frame));
    for (int row = 0; row < color_height; ++row)
      for (int column = 0; column < color_width; ++column) {
        const PointXYZRGBSigma& pixel = cloud.at(column, row);
        EXPECT_EQ(pixel.r, 10 + row);
        EXPECT_EQ(pixel.g, 200 + column);
        EXPECT_EQ(pixel.b, frame);
        const Measured* nearest = nullptr;
        for (const Measured& one : measured)
          if (one.column == column && one.row == row) {
            hidden += nearest ? 1 : 0;
            if (!nearest || one.point.z() < nearest->point.z())
              nearest = &one;
          }
        if (nearest) {
          const Eigen::Vector3d point = pixel.getVector3fMap().cast<double>();
          EXPECT_LT((point - nearest->point).norm(), 1e-6);
          EXPECT_NEAR(pixel.sigma, nearest->sigma, 1e-7);
          continue;
        }
        ++holes;
        EXPECT_TRUE(std::isnan(pixel.x) && std::isnan(pixel.y) && std::isnan(pixel.z));
        EXPECT_TRUE(std::isnan(pixel.sigma));
      }
  }
  EXPECT_GT(hidden, 4); // otherwise nothing is tested
  EXPECT_GT(holes, 4);
}

TEST_F(RgbdRegistration, PosesAreTheColourCameras)
{
  writeTwoCameras(3);
  runWith(colorCameraText()).succeeded();
  const Trajectory trajectory = loadTrajectory(output_ + "/trajectory.txt");
  ASSERT_EQ(trajectory.poses.size(), 3u);
  const Eigen::Isometry3d first = posedAt(0) * depthFromColor();
  for (int frame = 0; frame < 3; ++frame) {
    const Eigen::Isometry3d expected =
        first.inverse() * posedAt(frame) * depthFromColor();
    const auto& pose = trajectory.poses[static_cast<std::size_t>(frame)];
    EXPECT_TRUE(pose.matrix().isApprox(expected.matrix(), 1e-9));
    const Eigen::Vector3f seen = observation(frame).sensor_origin_.head<3>();
    EXPECT_LT((seen.cast<double>() - expected.translation()).norm(), 1e-5);
  }
}

TEST_F(RgbdRegistration, SameCameraChangesNothing)
{
  writeSevenScenes(input_, 2);
  run({"--registered"}).succeeded();
  const std::string before = contentOf(output_ + "/observation_0001.pcd");
  const std::string poses = contentOf(output_ + "/trajectory.txt");
  std::filesystem::remove_all(output_);
  runWith("focal_length_x: 10\nfocal_length_y: 20\ncenter_x: 3.5\ncenter_y: 2.5\n"
          "position: [0, 0, 0]\nrotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n")
      .succeeded();
  EXPECT_EQ(contentOf(output_ + "/observation_0001.pcd"), before);
  EXPECT_EQ(contentOf(output_ + "/trajectory.txt"), poses);
}

TEST_F(RgbdRegistration, KinectOfSevenScenesIsRegisteredUnlessToldOtherwise)
{
  writeKinect(420, 140, 2000);
  const std::string report = settings_.path("report.json");
  const ToolRun done = run({"--report", report}).succeeded();
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(done.out, HasSubstr("colour camera: 7-Scenes\n"));
  EXPECT_EQ(jsonOfFile(report)["color_camera"], "7-Scenes");
  // computed by hand: (0.341880, -0.341880, 2) m moves to (0.299586, -0.359004,
  // 2.001804) m
  EXPECT_EQ(onlyPixel(observation(0)), (std::pair<int, int>{399, 146}));
  std::filesystem::remove_all(output_);
  run({"--registered"}).succeeded();
  EXPECT_EQ(onlyPixel(observation(0)), (std::pair<int, int>{420, 140}));
}

TEST_F(RgbdRegistration, OtherDevicesInTheLayoutAreWarnedAbout)
{
  writeSevenScenes(input_, 1);
  const ToolRun done = run().succeeded();
  EXPECT_EQ(done.errorLines(), 1u) << done.err;
  EXPECT_THAT(done.err, HasSubstr("--color-camera"));
  EXPECT_THAT(done.err, HasSubstr("--registered"));
  EXPECT_THAT(done.out, HasSubstr("colour camera: none\n"));
}

TEST_F(RgbdRegistration, SizesStayTheSame)
{
  writeTwoCameras(3);
  input_.write("frame-000010.color.png", textOfBytes(encodePng(tellingColors(1))));
  expectRefused(runWith(colorCameraText()), 3, "frame-000010.color.png: has 8 x 6");
  writeTwoCameras(3);
  input_.write("frame-000020.depth.png", depthPngBytes(6, 8, tellingDepths(2)));
  expectRefused(runWith(colorCameraText()), 3, "frame-000020.depth.png: has 6 x 8");
  expectRefused(run({"--registered"}), 3, "frame-000020.depth.png: has 6 x 8");
}

TEST_F(RgbdRegistration, CameraThatLooksElsewhereSeesNoPoint)
{
  writeTwoCameras(1);
  Eigen::Isometry3d behind = depthFromColor();
  behind.linear() =
      Eigen::AngleAxisd(3.14159265, Eigen::Vector3d::UnitY()).toRotationMatrix();
  expectRefused(runWith(colorCameraText(behind)), 4, "no depth image has a point");
}

TEST_F(RgbdRegistration, NonsenseIsRefusedWithFileAndLine)
{
  writeTwoCameras(1);
  const std::string good = colorCameraText();
  const auto refuses =
      [&](const std::string& from, const std::string& to, const std::string& word) {
        SCOPED_TRACE(to);
        std::string bad = good;
        const std::size_t at = bad.find(from);
        ASSERT_NE(at, std::string::npos);
        expectRefused(runWith(bad.replace(at, from.size(), to)), 3, word);
      };
  refuses("focal_length_x: 7", "focal_length_x: 0", "line 1");
  refuses("focal_length_x: 7", "focal_length_x: nan", "line 1");
  refuses("focal_length_x: 7\n", "", "focal_length_x");
  refuses("focal_length_x: 7", "focal_length: 7", "focal_length_y");
  refuses("center_y: 3.5", "center_y: 1e300", "line 4");
  refuses("center_x", "centre_x", "centre_x");
  refuses("position: [", "position: [1, ", "line 5");
  refuses("position: [0.05", "position: [50", "line 5");
  refuses("position", "place", "place");
  refuses("rotation: [[0.9", "rotation: [[0.5", "is no rotation");
  refuses("rotation: [[0.", "rotation: [[-0.", "is no rotation");
  refuses("rotation: [[", "rotation: [[inf, ", "line 6");
  refuses("rotation: [[", "rotation: [[0, 0, 1], [", "line 6");
  for (const char* text : {"", "x", "[1, 2]", "\x01\xff", "a: [", "rotation: 3\n"})
    expectRefused(runWith(text), 3, "color.yaml");
  expectRefused(run({"--color-camera", input_.path("none")}), 3, "none");
}

TEST_F(RgbdRegistration, OtherLayoutsTakeAColourCameraToo)
{
  writeTum(input_, 2);
  const std::string depth = input_.write("k.txt", "10 0 3.5\n0 20 2.5\n0 0 1\n");
  const std::string color = settings_.write("color.yaml", colorCameraText());
  run({"--intrinsics", depth, "--depth-scale", "1000", "--color-camera", color})
      .succeeded();
  const Cloud cloud = observation(1);
  std::size_t found = 0;
  for (const Measured& one : measuredIn(tellingDepths(1)))
    if (one.column >= 0 && one.column < 8 && one.row >= 0 && one.row < 6) {
      const float z = cloud.at(one.column, one.row).z;
      EXPECT_LE(z, one.point.z() + 1e-6);
      ++found;
    }
  EXPECT_GT(found, 10u);
}

} // namespace
} // namespace pcl::acmap::test
