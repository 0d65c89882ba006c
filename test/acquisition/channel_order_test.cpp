#include "session_frames.h"

#include <pcl/acquisition/channel_order.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr ChannelOrder default_order{
    RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};

std::vector<ChannelOrder>
allOrders()
{
  std::vector<ChannelOrder> orders;
  ChannelOrder order = default_order;
  do
    orders.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return orders;
}

/** Cameras with rotations, displacements and distortion. */
RigCalibration
askewCameras()
{
  RigCalibration cameras = calibrationOf(TrinocularRig());
  const auto turn = [&](RigCamera camera, const Eigen::Vector3d& axis, double angle) {
    CameraCalibration& turned = cameras.camera(camera);
    turned.T_reference_camera.rotate(Eigen::AngleAxisd(angle, axis.normalized()));
    turned.distortion = {-0.2, 0.06, 3e-4, -2e-4, 0};
    turned.center_x += 100 * angle;
  };
  turn(RigCamera::Reference, Eigen::Vector3d::UnitX(), 0);
  turn(RigCamera::Horizontal, {1, -2, 0.5}, 0.03);
  turn(RigCamera::Vertical, {-1, 1, 2}, 0.025);
  return cameras;
}

/** A corner of a room with plain walls. */
SimulatedScene
room()
{
  constexpr SurfaceLook look{{168, 166, 160}, 2.0};
  SimulatedScene scene;
  scene.geometry.addRectangle(
      "wall", "wall", {{-8, 4, 3}, {16, 0, 4}, {0, -8, 0}}, look);
  scene.geometry.addBox("box", {-0.25, -0.25, 1.5}, {0.25, 0.25, 2.0}, look);
  scene.views = {Eigen::Isometry3d::Identity()};
  return scene;
}

/** A frame of the room under a pattern, or without pattern if there is none. */
TrinocularFrame
filmUnder(const std::vector<RgbImage>& patterns, const RigCalibration& cameras)
{
  return *SimulatedRigGrabber(room(), patterns, cameras).observe(0).back();
}

TrinocularFrame
film(const RigCalibration& cameras)
{
  return filmUnder({RandomLinePattern().generate(3)}, cameras);
}

/** A frame that was unpacked with a wrong channel order. */
TrinocularFrame
mixedUp(const TrinocularFrame& frame,
        const ChannelOrder& own,
        const ChannelOrder& assumed)
{
  TrinocularFrame mixed = frame;
  for (std::size_t k = 0; k < own.size(); ++k)
    mixed.image(assumed[k]) = frame.image(own[k]);
  return mixed;
}

void
expectUncertain(const TrinocularFrame& frame, const RigCalibration& cameras)
{
  for (const ChannelOrder& assumed : allOrders()) {
    const ChannelOrderCheck check = checkChannelOrder(frame, assumed, cameras);
    EXPECT_FALSE(check.is_certain) << textOf(check.best) << ", share " << check.share;
    EXPECT_EQ(check.best, assumed);
  }
}

TEST(ChannelOrder, EveryOrderIsFoundOfRectifiedCameras)
{
  const RigCalibration cameras = calibrationOf(TrinocularRig());
  const TrinocularFrame frame = film(cameras);
  for (const ChannelOrder& own : allOrders())
    for (const ChannelOrder& assumed : {own, default_order}) {
      const ChannelOrderCheck check =
          checkChannelOrder(mixedUp(frame, own, assumed), assumed, cameras);
      EXPECT_EQ(textOf(check.best), textOf(own));
      EXPECT_TRUE(check.is_certain);
      EXPECT_GT(check.corners, 100U);
      EXPECT_GT(check.share, 0.6);
      EXPECT_LT(check.runner_up, 0.05);
    }
}

TEST(ChannelOrder, EveryOrderIsFoundOfCamerasAsTheyAreBuilt)
{
  const RigCalibration cameras = askewCameras();
  const TrinocularFrame frame = film(cameras);
  for (const ChannelOrder& own : allOrders()) {
    const ChannelOrderCheck check =
        checkChannelOrder(mixedUp(frame, own, default_order), default_order, cameras);
    EXPECT_EQ(textOf(check.best), textOf(own));
    EXPECT_TRUE(check.is_certain);
    EXPECT_GT(check.share, 0.6);
  }
}

TEST(ChannelOrder, GreyImagesDo)
{
  const RigCalibration cameras = calibrationOf(TrinocularRig());
  TrinocularFrame frame = film(cameras);
  for (CameraImage& image : frame.images) {
    CameraImage green{image.width, image.height, 1, {}};
    for (std::size_t i = 1; i < image.values.size(); i += 3)
      green.values.push_back(image.values[i]);
    image = green;
  }
  const ChannelOrder own{
      RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal};
  const ChannelOrderCheck check =
      checkChannelOrder(mixedUp(frame, own, default_order), default_order, cameras);
  EXPECT_EQ(check.best, own);
  EXPECT_TRUE(check.is_certain);
}

TEST(ChannelOrder, CamerasMayHaveMovedALittle)
{
  const RigCalibration cameras = askewCameras();
  RigCalibration moved = cameras;
  constexpr double about_a_pixel = 0.002; // radians
  moved.camera(RigCamera::Horizontal)
      .T_reference_camera.rotate(
          Eigen::AngleAxisd(about_a_pixel, Eigen::Vector3d::UnitX()));
  moved.camera(RigCamera::Vertical)
      .T_reference_camera.rotate(
          Eigen::AngleAxisd(-about_a_pixel, Eigen::Vector3d::UnitY()));
  const ChannelOrderCheck check =
      checkChannelOrder(film(moved), default_order, cameras);
  EXPECT_EQ(check.best, default_order);
  EXPECT_TRUE(check.is_certain);
}

TEST(ChannelOrder, CamerasThatAreNotTheseMakeNoOrderCertain)
{
  RigCalibration turned = calibrationOf(TrinocularRig());
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    turned.camera(camera).T_reference_camera.rotate(
        Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 1, 0).normalized()));
  const TrinocularFrame frame = film(calibrationOf(TrinocularRig()));
  for (const ChannelOrder& own : allOrders())
    EXPECT_FALSE(
        checkChannelOrder(mixedUp(frame, own, default_order), default_order, turned)
            .is_certain);
}

TEST(ChannelOrder, BlankWallsTellNothing)
{
  const RigCalibration cameras = calibrationOf(TrinocularRig());
  SimulatedScene blank = room();
  blank.geometry = {};
  blank.geometry.addRectangle("wall",
                              "wall",
                              {{-8, 4, 3}, {16, 0, 0}, {0, -8, 0}},
                              SurfaceLook{{168, 166, 160}, 2.0});
  expectUncertain(*SimulatedRigGrabber(blank, {}).observe(0).front(), cameras);
}

TEST(ChannelOrder, APatternThatRepeatsTellsNothing)
{
  const RigCalibration cameras = calibrationOf(TrinocularRig());
  RgbImage squares{1024, 768, {}};
  for (int y = 0; y < squares.height; ++y)
    for (int x = 0; x < squares.width; ++x)
      squares.values.insert(
          squares.values.end(), 3, (x / 16 + y / 16) % 2 == 0 ? 255 : 0);
  SimulatedScene wall = room();
  wall.geometry = {};
  wall.geometry.addRectangle("wall",
                             "wall",
                             {{-8, 4, 2}, {16, 0, 0}, {0, -8, 0}},
                             SurfaceLook{{168, 166, 160}, 2.0});
  const TrinocularFrame frame =
      *SimulatedRigGrabber(wall, {squares}, cameras).observe(0).back();
  for (const ChannelOrder& own : allOrders()) {
    const ChannelOrderCheck check =
        checkChannelOrder(mixedUp(frame, own, default_order), default_order, cameras);
    EXPECT_TRUE(!check.is_certain || check.best == own) << textOf(own);
  }
}

TEST(ChannelOrder, DarkCamerasTellNothing)
{
  const RigCalibration cameras = calibrationOf(TrinocularRig());
  const TrinocularFrame frame = film(cameras);
  for (std::size_t dark = 0; dark < 3; ++dark) {
    TrinocularFrame two = frame;
    std::fill(two.images[dark].values.begin(), two.images[dark].values.end(), 0);
    expectUncertain(two, cameras);
  }
}

TEST(ChannelOrder, OneImageOfAllCamerasTellsNothing)
{
  for (const RigCalibration& cameras :
       {calibrationOf(TrinocularRig()), askewCameras()}) {
    TrinocularFrame frame = film(cameras);
    frame.images[1] = frame.images[2] = frame.images[0];
    for (const ChannelOrder& assumed : allOrders())
      EXPECT_FALSE(checkChannelOrder(frame, assumed, cameras).is_certain);
  }
}

TEST(ChannelOrder, NoiseTellsNothing)
{
  Random random(4);
  TrinocularFrame frame;
  for (CameraImage& image : frame.images) {
    image = {640, 480, 3, std::vector<std::uint8_t>(std::size_t{640} * 480 * 3)};
    for (std::uint8_t& value : image.values)
      value = static_cast<std::uint8_t>(random.bits());
  }
  expectUncertain(frame, calibrationOf(TrinocularRig()));
}

TEST(ChannelOrder, ImagesOfAnySizeAreTaken)
{
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 300}, {300, 1}, {15, 15}, {16, 16}, {17, 40}, {64, 48}}) {
    const TrinocularRig rig = rigOf(width, height);
    const ChannelOrderCheck check =
        checkChannelOrder(frameOf(rig, 0, 0, 0), default_order, calibrationOf(rig));
    EXPECT_FALSE(check.is_certain);
    EXPECT_EQ(check.best, default_order);
  }
}

TEST(ChannelOrder, WhatCannotBeCheckedIsRefused)
{
  const TrinocularRig rig = rigOf(32, 24);
  const TrinocularFrame whole = frameOf(rig, 0, 0, 0);
  const RigCalibration cameras = calibrationOf(rig);
  const auto faultOf = [](const TrinocularFrame& frame,
                          const RigCalibration& calibration,
                          const ChannelOrder& assumed = default_order) {
    return faultOfRunning<BadArgumentException>(
        [&] { checkChannelOrder(frame, assumed, calibration); });
  };
  TrinocularFrame frame = whole;
  frame.image(RigCamera::Vertical) = {};
  EXPECT_THAT(faultOf(frame, cameras), HasSubstr("vertical image is missing"));
  frame = whole;
  frame.image(RigCamera::Horizontal).values.pop_back();
  EXPECT_THAT(faultOf(frame, cameras), HasSubstr("horizontal image"));
  EXPECT_THAT(faultOf(whole, calibrationOf(rigOf(24, 32))),
              HasSubstr("32 x 24 pixels, the calibration 24 x 32"));
  TrinocularRig pair = rig;
  pair.baseline_vertical = 0;
  EXPECT_THAT(faultOf(whole, calibrationOf(pair)), HasSubstr("three are needed"));
  RigCalibration broken = cameras;
  broken.cameras[1].focal_x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(faultOf(whole, broken), "");
  const ChannelOrder twice{
      RigCamera::Vertical, RigCamera::Horizontal, RigCamera::Vertical};
  EXPECT_THAT(faultOf(whole, cameras, twice), HasSubstr("has a camera twice"));
}

TEST(ChannelOrder, OrdersHaveNames)
{
  EXPECT_EQ(textOf(default_order), "reference,horizontal,vertical");
  EXPECT_EQ(textOf({RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal}),
            "vertical,reference,horizontal");
}

} // namespace
} // namespace pcl::acmap::test
