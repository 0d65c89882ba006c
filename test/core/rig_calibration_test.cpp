#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/rig_calibration.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

CameraCalibration
distortedCamera(const std::array<double, 5>& distortion)
{
  CameraCalibration camera;
  camera.focal_x = 521.7;
  camera.focal_y = 518.3;
  camera.center_x = 331.25;
  camera.center_y = 236.5;
  camera.distortion = distortion;
  camera.is_there = true;
  return camera;
}

RigCalibration
turnedRig()
{
  RigCalibration rig;
  rig.cameras.fill(distortedCamera({-0.25, 0.08, 5e-4, -4e-4, 1.0 / 3.0}));
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::AngleAxisd turn(0.03, axis);
  auto& horizontal = rig.camera(RigCamera::Horizontal).T_reference_camera;
  horizontal = Eigen::Translation3d(-0.1003, 0.0007, -0.0011) * turn;
  auto& vertical = rig.camera(RigCamera::Vertical).T_reference_camera;
  vertical = Eigen::Translation3d(0.0004, -0.0998, 0.0009) * turn.inverse();
  return rig;
}

/** \brief Checks the inverse at many pixels up to and beyond the image border. */
void
expectInverse(const CameraCalibration& camera)
{
  for (double row = -10.25; row < 490; row += 7.3)
    for (double column = -10.25; column < 650; column += 7.3) {
      const Eigen::Vector2d pixel(column, row);
      const Eigen::Vector3d ray = pixelRay(camera, pixel);
      ASSERT_NEAR(ray.norm(), 1.0, 1e-14);
      ASSERT_LT((projectPoint(camera, 3.7 * ray) - pixel).norm(), 1e-9)
          << column << ", " << row;
    }
}

TEST(RigCalibration, RaysComeBackToTheirPixels)
{
  expectInverse(distortedCamera({0, 0, 0, 0, 0}));
  expectInverse(distortedCamera({-0.25, 0.08, 5e-4, -4e-4, 0}));
  expectInverse(distortedCamera({-0.45, 0.28, -3e-3, 2e-3, -0.05}));
  expectInverse(distortedCamera({0.6, 0.3, 4e-3, -5e-3, 0.2}));
}

TEST(RigCalibration, ProjectsAsOpenCvsModelIsWritten)
{
  const CameraCalibration camera = distortedCamera({-0.2, 0.1, 0.01, 0.02, -0.03});
  // x = .3, y = -.4: r2 = .25, radial = 1 - .05 + .00625 - .00046875 = .95578125.
  const Eigen::Vector2d pixel = projectPoint(camera, {0.6, -0.8, 2.0});
  const double x = 0.3 * 0.95578125 + 2 * 0.01 * -0.12 + 0.02 * (0.25 + 0.18);
  const double y = -0.4 * 0.95578125 + 0.01 * (0.25 + 0.32) + 2 * 0.02 * -0.12;
  EXPECT_NEAR(pixel.x(), 521.7 * x + 331.25, 1e-10);
  EXPECT_NEAR(pixel.y(), 518.3 * y + 236.5, 1e-10);
}

TEST(RigCalibration, WhatCannotBeSeenIsNaN)
{
  // r - r^3 / 4 has its maximum .7698 at r = 1.1547: larger radii cannot be reached.
  const CameraCalibration folded = distortedCamera({-0.25, 0, 0, 0, 0});
  const auto at = [](double r) { return Eigen::Vector2d(331.25 + 521.7 * r, 236.5); };
  EXPECT_TRUE(pixelRay(folded, at(0.78)).hasNaN());
  EXPECT_TRUE(pixelRay(folded, at(5.0)).hasNaN());
  const Eigen::Vector3d ray = pixelRay(folded, at(0.76));
  EXPECT_LT(ray.x() / ray.z(), 1.1547); // not the solution beyond the maximum
  EXPECT_TRUE(pixelRay(folded, at(std::nan(""))).hasNaN());
  EXPECT_TRUE(projectPoint(folded, {0.1, 0.1, 0.0}).hasNaN());
  EXPECT_TRUE(projectPoint(folded, {0.1, 0.1, -1.0}).hasNaN());
}

TEST(RigCalibration, RectifiedRigHasPlainCameras)
{
  TrinocularRig rig;
  rig.baseline_vertical = 0;
  const RigCalibration cameras = calibrationOf(rig);
  EXPECT_TRUE(cameras.camera(RigCamera::Reference).is_there);
  EXPECT_FALSE(cameras.camera(RigCamera::Vertical).is_there);
  const CameraCalibration& left = cameras.camera(RigCamera::Horizontal);
  EXPECT_EQ(left.T_reference_camera.translation(), Eigen::Vector3d(-0.1, 0, 0));
  const Eigen::Vector3d point(0.2, 0.3, 2.0);
  const Eigen::Vector2d seen =
      projectPoint(left, left.T_reference_camera.inverse() * point);
  EXPECT_NEAR(seen.x(), 319.5 + 520 * 0.15, 1e-12);
  EXPECT_NEAR(seen.y(), 239.5 + 520 * 0.15, 1e-12);
}

TEST(RigCalibration, SurvivesItsFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("rig.yaml");
  RigCalibration rig = turnedRig();
  TrinocularRig rectified;
  rectified.focal_length = 533.3333333333;
  for (const bool has_vertical : {true, false}) {
    rig.camera(RigCamera::Vertical).is_there = has_vertical;
    if (!has_vertical)
      rectified.baseline_vertical = 0;
    saveRigCalibration(path, rectified, rig);
    EXPECT_EQ(loadTrinocularRig(path).focal_length, rectified.focal_length);
    const RigCalibration read = loadRigCalibration(path);
    EXPECT_EQ(read.width, 640);
    EXPECT_EQ(read.height, 480);
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(read.cameras[i].is_there, rig.cameras[i].is_there);
      if (!rig.cameras[i].is_there)
        continue;
      EXPECT_EQ(read.cameras[i].focal_x, rig.cameras[i].focal_x);
      EXPECT_EQ(read.cameras[i].focal_y, rig.cameras[i].focal_y);
      EXPECT_EQ(read.cameras[i].center_x, rig.cameras[i].center_x);
      EXPECT_EQ(read.cameras[i].center_y, rig.cameras[i].center_y);
      EXPECT_EQ(read.cameras[i].distortion, rig.cameras[i].distortion);
      EXPECT_EQ(read.cameras[i].T_reference_camera.matrix(),
                rig.cameras[i].T_reference_camera.matrix());
    }
  }
}

/** \brief Error message after a text was replaced in a valid file. */
std::string
faultAfter(const std::string& from, const std::string& to, std::size_t nth = 0)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("rig.yaml");
  RigCalibration rig = turnedRig();
  saveRigCalibration(path, {}, rig);
  std::string text = contentOf(path);
  std::size_t at = text.find(from);
  for (; nth > 0 && at != std::string::npos; --nth)
    at = text.find(from, at + 1);
  if (at == std::string::npos)
    return "'" + from + "' is not in the file";
  folder.write("rig.yaml", text.replace(at, from.size(), to));
  return messageOf<InputFileException>([&] { loadRigCalibration(path); });
}

TEST(RigCalibration, UglyFilesAreNamed)
{
  EXPECT_EQ(faultAfter("width", "width"), "");
  EXPECT_THAT(faultAfter("521.7", ".nan"), HasSubstr("rig.yaml: line 16"));
  EXPECT_THAT(faultAfter("521.7", "-521.7"), HasSubstr("focal length is below 1 px"));
  EXPECT_THAT(faultAfter("518.3", "0"), HasSubstr("focal length is below 1 px"));
  EXPECT_THAT(faultAfter("521.7, 0", "521.7, 2"), HasSubstr("not of the form"));
  EXPECT_THAT(faultAfter("rows: 3", "rows: 4"), HasSubstr("rows: '4'"));
  EXPECT_THAT(faultAfter("cols: 5", "cols: 8"), HasSubstr("cols: '8'"));
  EXPECT_THAT(faultAfter("-0.25, ", ""), HasSubstr("data"));
  EXPECT_THAT(faultAfter("-0.25, ", "wide, "), HasSubstr("'wide'"));
  EXPECT_THAT(faultAfter("0, 0, 0, 1 ]", "0, 0, 0, 2 ]", 1), HasSubstr("no rigid"));
  EXPECT_THAT(faultAfter("-0.1003", "-1e9"), HasSubstr("'-1e9'"));
  EXPECT_THAT(faultAfter("-0.1003", ".inf"), HasSubstr("'.inf'"));
  EXPECT_THAT(faultAfter("data: [ 1, 0, 0, 0", "data: [ 1, 0, 0, 0.1"),
              HasSubstr("identity"));
  EXPECT_THAT(faultAfter("baseline_vertical: -0.1", "baseline_vertical: 0"),
              HasSubstr("rig.yaml: a camera must be there exactly when"));
  EXPECT_THAT(faultAfter("camera_vertical", "camera_top"), HasSubstr("exactly when"));
  EXPECT_THAT(faultAfter("pose", "place"), HasSubstr("'pose' is missing"));
  EXPECT_THAT(faultAfter("camera_reference", "camera"), HasSubstr("rectified rig"));
  EXPECT_THAT(faultAfter("width: 640", "width: 640000"), HasSubstr("'640000'"));
}

TEST(RigCalibration, ReadsColumnsOfOpenCv)
{
  EXPECT_EQ(faultAfter("rows: 1\n    cols: 5", "rows: 5\n    cols: 1"), "");
}

TEST(RigCalibration, NonsenseIsNotWritten)
{
  const TemporaryFolder folder;
  const auto refused = [&](const std::function<void(RigCalibration&)>& spoil) {
    RigCalibration rig = turnedRig();
    spoil(rig);
    EXPECT_THROW(saveRigCalibration(folder.path("rig.yaml"), {}, rig),
                 BadArgumentException);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([&](RigCalibration& rig) { rig.cameras[1].focal_x = nan; });
  refused([&](RigCalibration& rig) { rig.cameras[0].focal_y = 0; });
  refused([&](RigCalibration& rig) { rig.cameras[2].distortion[4] = nan; });
  refused([&](RigCalibration& rig) { rig.cameras[1].center_x = nan; });
  refused([&](RigCalibration& rig) { rig.cameras[1].is_there = false; });
  refused([&](RigCalibration& rig) { rig.cameras[0].is_there = false; });
  refused([&](RigCalibration& rig) { rig.width = 320; });
  refused([&](RigCalibration& rig) {
    rig.cameras[1].T_reference_camera.linear() *= 1.001;
  });
  refused([&](RigCalibration& rig) {
    rig.cameras[2].T_reference_camera.linear().col(0) *= -1;
  });
  refused([&](RigCalibration& rig) {
    rig.cameras[0].T_reference_camera.translation().x() = 0.1;
  });
  EXPECT_THROW(saveRigCalibration(folder.path("none/rig.yaml"), {}, turnedRig()),
               OutputFileException);
  EXPECT_EQ(folder.count(), 0);
}

TEST(RigCalibration, CamerasThatCannotBeAreNamedWithValueAndRange)
{
  EXPECT_NO_THROW(requireSoundCalibration(turnedRig()));
  const auto faultAfter = [](const std::function<void(RigCalibration&)>& spoil) {
    RigCalibration rig = turnedRig();
    spoil(rig);
    try {
      requireSoundCalibration(rig);
    }
    catch (const BadArgumentException& exception) {
      return std::string(exception.what());
    }
    return std::string();
  };
  const auto fault =
      faultAfter([](RigCalibration& rig) { rig.cameras[2].focal_y = 0.5; });
  EXPECT_THAT(fault, HasSubstr("camera_vertical: focal_y = 0.5"));
  EXPECT_THAT(fault, HasSubstr("[1, 1e+06] px"));
  EXPECT_THAT(faultAfter([](RigCalibration& rig) { rig.height = 0; }),
              HasSubstr("height = 0"));
  EXPECT_THAT(faultAfter([](RigCalibration& rig) {
                rig.cameras[1].T_reference_camera.translation().z() = 101;
              }),
              HasSubstr("camera_horizontal: pose is more than 100 m"));
  EXPECT_EQ(faultAfter([](RigCalibration& rig) {
              rig.cameras[1].is_there = false; // its other values are then ignored
              rig.cameras[1].focal_x = -1;
            }),
            "");
}

} // namespace
} // namespace pcl::acmap::test
