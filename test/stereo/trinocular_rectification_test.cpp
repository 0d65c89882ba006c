#include "rendered_boards.h"

#include <pcl/core/exceptions.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

TrinocularRectification
rectificationOf(const RigCalibration& rig)
{
  TrinocularRectification rectification;
  rectification.setInputCalibration(rig);
  return rectification;
}

/** \brief Rectified position of a point of the reference's frame in a camera of the
 * real rig. */
Eigen::Vector2d
rectifiedPlace(const TrinocularRectification& rectification,
               const RigCalibration& rig,
               RigCamera camera,
               const Eigen::Vector3d& point)
{
  const CameraCalibration& built = rig.camera(camera);
  return rectification.rectifiedPixel(
      camera, projectPoint(built, built.T_reference_camera.inverse() * point));
}

TEST(TrinocularRectification, PointsShareRowsAndColumns)
{
  const RigCalibration built = builtRig();
  const TrinocularRectification rectification = rectificationOf(built);
  const TrinocularRig& rig = rectification.getRig();
  for (double z = 0.6; z < 5.0; z += 0.7)
    for (double x = -0.4; x < 0.41; x += 0.1)
      for (double y = -0.3; y < 0.31; y += 0.1) {
        const auto place = [&](RigCamera camera) {
          return rectifiedPlace(rectification, built, camera, {x * z, y * z, z});
        };
        const Eigen::Vector2d reference = place(RigCamera::Reference);
        const Eigen::Vector2d right = place(RigCamera::Horizontal) - reference;
        const Eigen::Vector2d down = place(RigCamera::Vertical) - reference;
        ASSERT_NEAR(right.y(), 0.0, 1e-6);
        ASSERT_NEAR(down.x(), 0.0, 1e-3); // the residual skew of the rig
        // both disparities belong to the same depth
        ASSERT_GT(right.x(), 0.0);
        ASSERT_NEAR(rig.baseline_horizontal / right.x(),
                    rig.baseline_vertical / down.y(),
                    1e-6);
        ASSERT_NEAR(
            -rig.focal_length * rig.baseline_horizontal / right.x(), z, 0.05 * z);
      }
  EXPECT_NEAR(rig.baseline_horizontal, -0.1, 1e-5);
  EXPECT_NEAR(rig.baseline_vertical, -0.1, 1e-5);
  EXPECT_GT(rig.focal_length, 400);
  EXPECT_LT(rig.focal_length, 650);
}

double
waves(double x, double y)
{
  x *= 40;
  y *= 40;
  return 130 + 50 * std::sin(x + 0.7 * y) + 45 * std::cos(0.4 * x - 1.3 * y) +
         20 * std::sin(2.1 * x) * std::sin(1.7 * y);
}

/** \brief Rectified images of a texture at a known depth must be equal to those
 * rendered for the rectified rig without distortion. */
TEST(TrinocularRectification, ImagesAreThoseOfTheRectifiedRig)
{
  const RigCalibration built = builtRig();
  const TrinocularRectification rectification = rectificationOf(built);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0.5).normalized())
                      .toRotationMatrix();
  pose.translation() << 0.05, -0.02, 1.1;
  TrinocularFrame rectified;
  rectification.rectify(RigRenderer(built).frameOf(pose, waves), rectified);

  const TrinocularRig& rig = rectification.getRig();
  const Eigen::Matrix3d turned = rectification.getRotation(RigCamera::Reference);
  Eigen::Isometry3d T_common_plane = Eigen::Isometry3d::Identity();
  T_common_plane.linear() = turned * pose.linear();
  T_common_plane.translation() = turned * pose.translation();
  const TrinocularFrame expected =
      RigRenderer(calibrationOf(rig)).frameOf(T_common_plane, waves);
  for (std::size_t camera = 0; camera < 3; ++camera) {
    const CameraImage& is = rectified.images[camera];
    const CameraImage& ought = expected.images[camera];
    ASSERT_EQ(is.values.size(), ought.values.size());
    double sum = 0;
    int worst = 0;
    for (std::size_t i = 0; i < is.values.size(); ++i) {
      const int off = std::abs(int(is.values[i]) - int(ought.values[i]));
      sum += off;
      worst = std::max(worst, off);
    }
    EXPECT_LT(sum / double(is.values.size()), 1.0) << camera;
    EXPECT_LE(worst, 6) << camera;
  }
}

TEST(TrinocularRectification, RotationsAreThoseOfThePixels)
{
  const RigCalibration built = builtRig();
  const TrinocularRectification rectification = rectificationOf(built);
  const CameraCalibration pinhole =
      calibrationOf(rectification.getRig()).camera(RigCamera::Reference);
  for (const RigCamera camera :
       {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical}) {
    const Eigen::Matrix3d rotation = rectification.getRotation(camera);
    EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-12));
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(50, 60), Eigen::Vector2d(600, 440)}) {
      const Eigen::Vector3d raw = pixelRay(built.camera(camera), pixel);
      const Eigen::Vector3d turned =
          pixelRay(pinhole, rectification.rectifiedPixel(camera, pixel));
      EXPECT_TRUE((rotation * raw).isApprox(turned, 1e-9));
    }
  }
}

TEST(TrinocularRectification, NoBorderIsEmpty)
{
  const TrinocularRectification rectification = rectificationOf(builtRig());
  TrinocularFrame frame;
  for (CameraImage& image : frame.images)
    image = {640, 480, 1, std::vector<std::uint8_t>(640 * 480, 200)};
  rectification.rectify(frame, frame);
  for (const CameraImage& image : frame.images)
    EXPECT_EQ(image.values, std::vector<std::uint8_t>(640 * 480, 200));
  // not larger than needed: one edge of a raw image is on an edge of the rectified one
  double nearest = 1e9;
  for (const RigCamera camera :
       {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical})
    for (int row = 0; row < 480; ++row) {
      const double left = rectification.rectifiedPixel(camera, {0.0, row}).x();
      EXPECT_LE(left, 1e-6);
      nearest = std::min(nearest, -left);
    }
  for (const RigCamera camera :
       {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical})
    for (int column = 0; column < 640; ++column)
      nearest =
          std::min(nearest, -rectification.rectifiedPixel(camera, {column, 0.0}).y());
  EXPECT_NEAR(nearest, 0.0, 1e-6);
}

TEST(TrinocularRectification, RectifiedRigIsLeftAsItIs)
{
  const TrinocularRig rig;
  const TrinocularRectification rectification = rectificationOf(calibrationOf(rig));
  EXPECT_NEAR(rectification.getRig().focal_length, rig.focal_length, 1e-9);
  EXPECT_NEAR(rectification.getRig().center_x, rig.center_x, 1e-9);
  EXPECT_NEAR(rectification.getRig().center_y, rig.center_y, 1e-9);
  EXPECT_EQ(rectification.getRig().baseline_vertical, rig.baseline_vertical);
  TrinocularFrame frame;
  frame.number = 7;
  frame.observation = 3;
  frame.pattern = 2;
  frame.stamp = 12345;
  CameraImage& image = frame.image(RigCamera::Horizontal);
  image = {640, 480, 3, {}};
  for (std::size_t i = 0; i < 640 * 480 * 3; ++i)
    image.values.push_back(static_cast<std::uint8_t>(i * 2654435761u >> 13));
  TrinocularFrame rectified;
  rectification.rectify(frame, rectified);
  EXPECT_TRUE(rectified.image(RigCamera::Horizontal) == image);
  EXPECT_TRUE(rectified.image(RigCamera::Reference).empty());
  EXPECT_TRUE(rectified.image(RigCamera::Vertical).empty());
  EXPECT_EQ(rectified.number, 7u);
  EXPECT_EQ(rectified.observation, 3);
  EXPECT_EQ(rectified.pattern, 2);
  EXPECT_EQ(rectified.stamp, 12345u);
}

TEST(TrinocularRectification, ThreadsDoNotMatter)
{
  const TrinocularFrame frame = boardShots(builtRig(), 1).front();
  std::vector<TrinocularFrame> results(3);
  for (std::size_t i = 0; i < results.size(); ++i) {
    TrinocularRectification rectification;
    rectification.setNumberOfThreads(std::array<unsigned, 3>{1, 2, 8}[i]);
    rectification.setInputCalibration(builtRig());
    rectification.rectify(frame, results[i]);
  }
  EXPECT_TRUE(results[0].images == results[1].images);
  EXPECT_TRUE(results[0].images == results[2].images);
}

TEST(TrinocularRectification, PairsDoWithOneNeighbour)
{
  for (const RigCamera missing : {RigCamera::Horizontal, RigCamera::Vertical}) {
    RigCalibration built = builtRig();
    built.camera(missing).is_there = false;
    const TrinocularRectification rectification = rectificationOf(built);
    const bool has_rows = missing == RigCamera::Vertical;
    const RigCamera other = has_rows ? RigCamera::Horizontal : RigCamera::Vertical;
    const Eigen::Vector3d point(0.2, 0.1, 1.3);
    const Eigen::Vector2d off =
        rectifiedPlace(rectification, built, other, point) -
        rectifiedPlace(rectification, built, RigCamera::Reference, point);
    EXPECT_NEAR(off[has_rows ? 1 : 0], 0.0, 1e-6);
    EXPECT_GT(off[has_rows ? 0 : 1], 10.0);
    EXPECT_EQ(rectification.getRig().baseline_vertical == 0.0, has_rows);
    EXPECT_EQ(rectification.getRig().baseline_horizontal == 0.0, !has_rows);
    EXPECT_THROW(rectification.rectifiedPixel(missing, {1, 1}), BadArgumentException);
    EXPECT_THROW(rectification.getRotation(missing), BadArgumentException);
  }
}

TEST(TrinocularRectification, SkewIsTold)
{
  RigCalibration built = calibrationOf(TrinocularRig());
  built.camera(RigCamera::Vertical).T_reference_camera.translation().x() = 0.002;
  TrinocularRectification rectification = rectificationOf(built);
  EXPECT_NEAR(rectification.getReport().column_offset, 0.002, 1e-9);
  EXPECT_NEAR(rectification.getReport().column_residual, 520 * 0.002, 0.01);
  EXPECT_EQ(rectification.getReport().remarks.size(), 1u);
  rectification.setNearestDepth(4.0);
  EXPECT_NEAR(rectification.getReport().column_residual, 520 * 0.002 / 4, 0.01);
  EXPECT_TRUE(rectification.getReport().remarks.empty());
  EXPECT_THROW(rectification.setNearestDepth(0.0), BadArgumentException);
  EXPECT_NEAR(rectificationOf(builtRig()).getReport().turns[0], 0.64, 0.3);
}

TEST(TrinocularRectification, RigsThatAreNoneAreRefused)
{
  TrinocularRectification rectification;
  const auto refused = [&](const std::string& word,
                           const std::function<void(RigCalibration&)>& change) {
    RigCalibration rig = builtRig();
    change(rig);
    EXPECT_THAT([&] { rectification.setInputCalibration(rig); },
                testing::ThrowsMessage<BadArgumentException>(HasSubstr(word)))
        << word << " was taken";
  };
  const auto h = RigCamera::Horizontal;
  const auto v = RigCamera::Vertical;
  const auto place = [](RigCalibration& rig, RigCamera camera) -> Eigen::Isometry3d& {
    return rig.camera(camera).T_reference_camera;
  };
  refused("at least one neighbour", [&](RigCalibration& rig) {
    rig.camera(h).is_there = rig.camera(v).is_there = false;
  });
  refused("reference camera's place",
          [&](RigCalibration& rig) { place(rig, h).translation().setZero(); });
  refused("in the direction of its name",
          [&](RigCalibration& rig) { std::swap(place(rig, h), place(rig, v)); });
  refused("60 degrees apart", [&](RigCalibration& rig) {
    place(rig, h).translation() << -0.1, -0.07, 0;
    place(rig, v).translation() << -0.07, -0.1, 0;
  });
  refused("rigid", [&](RigCalibration& rig) { place(rig, h).linear() *= 2.0; });
  refused("rigid",
          [&](RigCalibration& rig) { place(rig, h).matrix()(0, 3) = std::nan(""); });
  refused("focal_x", [&](RigCalibration& rig) { rig.camera(v).focal_x = -5; });
  refused("width", [&](RigCalibration& rig) { rig.width = 0; });
  refused("no ray", [&](RigCalibration& rig) {
    rig.camera(h).distortion = {-5, 0, 0, 0, 0};
  });
  refused("distortion",
          [&](RigCalibration& rig) { rig.camera(h).distortion[1] = std::nan(""); });
  refused("center_x",
          [&](RigCalibration& rig) { rig.camera(h).center_x = std::nan(""); });
  refused("camera_reference", [&](RigCalibration& rig) {
    place(rig, RigCamera::Reference).translation().x() = 1.0;
  });
  refused("turned too far", [&](RigCalibration& rig) {
    place(rig, h).linear() =
        Eigen::AngleAxisd(1.4, Eigen::Vector3d::UnitY()).toRotationMatrix();
  });
  EXPECT_THROW(rectification.getRig(), InitFailedException);
  EXPECT_THROW(rectification.getReport(), InitFailedException);
  EXPECT_THROW(rectification.getRotation(RigCamera::Reference), InitFailedException);
  TrinocularFrame frame;
  EXPECT_THROW(rectification.rectify(frame, frame), InitFailedException);
}

TEST(TrinocularRectification, FramesThatDoNotFitAreRefused)
{
  RigCalibration pair = builtRig();
  pair.camera(RigCamera::Vertical).is_there = false;
  const TrinocularRectification rectification = rectificationOf(pair);
  TrinocularFrame rectified;
  rectified.number = 99;
  const auto refused = [&](RigCamera camera, CameraImage image) {
    TrinocularFrame frame;
    frame.image(camera) = std::move(image);
    EXPECT_THROW(rectification.rectify(frame, rectified), BadArgumentException);
    EXPECT_EQ(rectified.number, 99u);
  };
  const auto bytes = [](std::size_t count) { return std::vector<std::uint8_t>(count); };
  refused(RigCamera::Reference, {320, 240, 1, bytes(320 * 240)});
  refused(RigCamera::Reference, {640, 480, 1, bytes(640 * 480 - 1)});
  refused(RigCamera::Reference, {640, 480, 2, bytes(640 * 480 * 2)});
  refused(RigCamera::Vertical, {640, 480, 1, bytes(640 * 480)});
}

} // namespace
} // namespace pcl::acmap::test
