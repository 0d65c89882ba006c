#include "lit_scenes.h"

#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <thread>

namespace pcl::acmap::test {
namespace {

using FrameCallback = TrinocularGrabber::FrameCallback;

std::function<FrameCallback>
callback(const std::function<void(const TrinocularFrame::ConstPtr&)>& function)
{
  return function;
}

/** Three views of an office, two patterns. */
struct Given {
  SimulatedScene scene = smallScene("office", 64);
  SimulatedLight light = plainLight();
  std::vector<RgbImage> patterns{wavePattern(light.projector),
                                 flatPattern(light.projector, 90)};

  Given()
  {
    scene.views.resize(3);
    light.read_noise = 2.0;
  }
};

void
expectEqualFrames(const TrinocularFrame& a, const TrinocularFrame& b)
{
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.observation, b.observation);
  EXPECT_EQ(a.pattern, b.pattern);
  EXPECT_EQ(a.stamp, b.stamp);
  EXPECT_EQ(a.images, b.images);
}

TEST(SimulatedRigGrabber, StreamsAllShotsInOrder)
{
  const Given given;
  SimulatedRigGrabber grabber(given.scene, given.patterns, given.light);
  EXPECT_EQ(grabber.getName(), "SimulatedRigGrabber");
  EXPECT_TRUE(grabber.providesCallback<FrameCallback>());
  EXPECT_EQ(grabber.getShotsOfObservation(), 3u);
  std::vector<TrinocularFrame::ConstPtr> frames;
  grabber.registerCallback(
      callback([&](const auto& frame) { frames.push_back(frame); }));
  grabber.start();
  grabber.wait();
  EXPECT_FALSE(grabber.isRunning());
  EXPECT_FALSE(grabber.getError());
  ASSERT_EQ(frames.size(), 9u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i]->number, i);
    EXPECT_EQ(frames[i]->observation, static_cast<int>(i / 3));
    EXPECT_EQ(frames[i]->pattern, static_cast<int>(i % 3) - 1);
    EXPECT_EQ(frames[i]->stamp, i * 1000000 / 14);
    for (const CameraImage& image : frames[i]->images) {
      EXPECT_EQ(image.width, 64);
      EXPECT_EQ(image.height, 48);
      EXPECT_EQ(image.channels, 3);
      EXPECT_EQ(image.values.size(), 3u * 64u * 48u);
    }
  }
  const auto second = grabber.observe(1);
  ASSERT_EQ(second.size(), 3u);
  for (std::size_t i = 0; i < second.size(); ++i)
    expectEqualFrames(*second[i], *frames[3 + i]);
}

TEST(SimulatedRigGrabber, ThreadsGiveTheSameBytesAndSeedsOthers)
{
  const Given given;
  const auto framesWith = [&](unsigned threads, std::uint64_t seed) {
    SimulatedRigGrabber grabber(given.scene, given.patterns, given.light);
    grabber.setNumberOfThreads(threads);
    grabber.setSeed(seed);
    return grabber.observe(2);
  };
  const auto once = framesWith(1, 5);
  for (const unsigned threads : {2u, 8u}) {
    const auto again = framesWith(threads, 5);
    for (std::size_t i = 0; i < once.size(); ++i)
      expectEqualFrames(*again[i], *once[i]);
  }
  EXPECT_FALSE(framesWith(1, 6)[0]->images == once[0]->images);
}

TEST(SimulatedRigGrabber, NothingIsCalledAfterStop)
{
  const Given given;
  SimulatedRigGrabber grabber(given.scene, given.patterns, given.light);
  std::atomic<int> calls{0};
  grabber.registerCallback(callback([&](const auto&) { ++calls; }));
  grabber.start();
  grabber.start(); // has no effect
  while (calls == 0 && grabber.isRunning())
    std::this_thread::yield();
  grabber.stop();
  const int until_stop = calls;
  EXPECT_FALSE(grabber.isRunning());
  EXPECT_LE(until_stop, 9);
  grabber.stop();
  grabber.wait();
  EXPECT_EQ(calls, until_stop);
  grabber.start(); // continues
  grabber.wait();
  EXPECT_EQ(calls, 9);
  grabber.start(); // at the end
  grabber.wait();
  EXPECT_EQ(calls, 9);
  grabber.rewind();
  grabber.start();
  grabber.wait();
  EXPECT_EQ(calls, 18);
}

TEST(SimulatedRigGrabber, TriggerGivesOneShotAfterTheOther)
{
  const Given given;
  SimulatedRigGrabber grabber(given.scene, given.patterns, given.light);
  grabber.setNumberOfObservations(2);
  std::vector<TrinocularFrame::ConstPtr> frames;
  grabber.registerCallback(
      callback([&](const auto& frame) { frames.push_back(frame); }));
  for (std::size_t i = 1; i <= 8; ++i) {
    grabber.trigger();
    grabber.wait();
    ASSERT_EQ(frames.size(), std::min<std::size_t>(i, 6));
  }
  expectEqualFrames(*frames[4], *grabber.observe(1)[1]);
}

TEST(SimulatedRigGrabber, SettingsCountFromTheFirstShotOn)
{
  const Given given;
  SimulatedRigGrabber grabber(given.scene, given.patterns, given.light);
  std::vector<TrinocularFrame::ConstPtr> frames;
  grabber.registerCallback(
      callback([&](const auto& frame) { frames.push_back(frame); }));
  const auto trigger = [&] {
    grabber.trigger();
    grabber.wait();
  };
  trigger();
  const auto before = grabber.observe(0);
  grabber.setSeed(7);
  trigger();
  grabber.rewind();
  trigger();
  ASSERT_EQ(frames.size(), 3u);
  expectEqualFrames(*frames[0], *before[0]);
  expectEqualFrames(*frames[1], *before[1]);
  expectEqualFrames(*frames[2], *grabber.observe(0)[0]);
  EXPECT_FALSE(frames[2]->images == frames[0]->images);
}

TEST(SimulatedRigGrabber, ACameraThatIsNotThereIsEmpty)
{
  Given given;
  given.scene.rig.baseline_vertical = 0;
  const SimulatedRigGrabber grabber(given.scene, {}, given.light);
  const auto frames = grabber.observe(0);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0]->pattern, TrinocularFrame::no_pattern);
  EXPECT_TRUE(frames[0]->image(RigCamera::Vertical).empty());
  EXPECT_EQ(frames[0]->image(RigCamera::Vertical).width, 0);
  EXPECT_FALSE(frames[0]->image(RigCamera::Horizontal).empty());
}

TEST(SimulatedRigGrabber, BuiltCamerasWithoutFaultsSeeAsTheRectified)
{
  Given given;
  given.light.read_noise = 0.0;
  const SimulatedRigGrabber ideal(given.scene, given.patterns, given.light);
  const SimulatedRigGrabber built(
      given.scene, given.patterns, calibrationOf(given.scene.rig), given.light);
  const auto a = ideal.observe(1)[1];
  const auto b = built.observe(1)[1];
  for (std::size_t camera = 0; camera < 3; ++camera) {
    const auto& x = a->images[camera].values;
    const auto& y = b->images[camera].values;
    ASSERT_EQ(x.size(), y.size());
    std::size_t differ = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      differ += std::abs(x[i] - y[i]) > 1 ? 1 : 0;
    EXPECT_LE(differ, x.size() / 1000); // at edges the result can depend on rounding
  }
}

TEST(SimulatedRigGrabber, DistortedAndTurnedCamerasBendAnEdge)
{
  SimulatedScene scene = wallAt(3.0);
  scene.geometry.addRectangle(
      "dark", "dark", {{0.9, 5, 2}, {5, 0, 0}, {0, -10, 0}}, {{10, 10, 10}, 0});
  RigCalibration calibration = calibrationOf(scene.rig);
  CameraCalibration& left = calibration.camera(RigCamera::Horizontal);
  left.distortion = {-0.2, 0.05, 0.002, -0.001, 0.0};
  left.focal_y *= 1.01;
  left.T_reference_camera.linear() =
      Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.3, 0.5, 0.8).normalized())
          .toRotationMatrix();
  SimulatedLight light = plainLight();
  light.projector.power = 0.0;
  const SimulatedRigGrabber grabber(scene, {}, calibration, light);
  const CameraImage image = grabber.observe(0)[0]->image(RigCamera::Horizontal);
  // In each row, the edge x = 0.9 at z = 2 separates bright and dark pixels.
  double minimum = 1e9, maximum = 0;
  for (double y = -0.8; y <= 0.8; y += 0.02) {
    const Eigen::Vector2d at = projectPoint(
        left, left.T_reference_camera.inverse() * Eigen::Vector3d(0.9, y, 2));
    const int row = static_cast<int>(std::lround(at.y()));
    if (row < 0 || row >= image.height || std::abs(at.y() - row) > 0.1)
      continue;
    const int column = static_cast<int>(std::floor(at.x()));
    ASSERT_LT(column + 2, image.width);
    EXPECT_EQ(valueAt(image, column - 1, row), 50) << y;
    EXPECT_EQ(valueAt(image, column + 2, row), 5) << y;
    minimum = std::min(minimum, at.x());
    maximum = std::max(maximum, at.x());
  }
  EXPECT_GT(maximum - minimum, 3.0); // distortion bends the straight edge
}

TEST(SimulatedRigGrabber, NonsenseIsRefused)
{
  Given given;
  const auto make = [&] {
    SimulatedRigGrabber(given.scene, given.patterns, given.light);
  };
  EXPECT_NO_THROW(make());
  const Given sound = given;
  given.patterns[1].width = 100;
  EXPECT_THROW(make(), BadArgumentException);
  given = sound;
  given.patterns[0].values.pop_back();
  EXPECT_THROW(make(), BadArgumentException);
  given = sound;
  given.scene.views.clear();
  EXPECT_THROW(make(), BadArgumentException);
  given = sound;
  given.scene.rig.width = 0;
  EXPECT_THROW(make(), BadArgumentException);
  given = sound;
  SimulatedRigGrabber grabber(given.scene, given.patterns, given.light);
  EXPECT_THROW(grabber.setNumberOfObservations(0), BadArgumentException);
  EXPECT_THROW(grabber.setNumberOfObservations(4), BadArgumentException);
  EXPECT_THROW(grabber.observe(3), BadArgumentException);
  RigCalibration calibration = calibrationOf(given.scene.rig);
  calibration.camera(RigCamera::Vertical).focal_x = std::nan("");
  EXPECT_THROW(SimulatedRigGrabber(given.scene, {}, calibration), BadArgumentException);
}

TEST(SimulatedLight, NonsenseIsRefused)
{
  EXPECT_NO_THROW(requireSoundLight({}));
  for (double SimulatedLight::*const value : {&SimulatedLight::ambient,
                                              &SimulatedLight::exposure,
                                              &SimulatedLight::read_noise,
                                              &SimulatedLight::shot_noise,
                                              &SimulatedLight::blur})
    for (const double bad : {-0.1, std::nan(""), 1e9}) {
      SimulatedLight light;
      light.*value = bad;
      EXPECT_THROW(requireSoundLight(light), BadArgumentException) << bad;
    }
  for (double SimulatedProjector::*const value : {&SimulatedProjector::focal_length,
                                                  &SimulatedProjector::center_x,
                                                  &SimulatedProjector::center_y,
                                                  &SimulatedProjector::aperture_radius,
                                                  &SimulatedProjector::power,
                                                  &SimulatedProjector::falloff_distance,
                                                  &SimulatedProjector::blur})
    for (const double bad : {-1e9, std::nan(""), 1e9}) {
      SimulatedLight light;
      light.projector.*value = bad;
      EXPECT_THROW(requireSoundLight(light), BadArgumentException) << bad;
    }
  SimulatedLight light;
  light.projector.width = 1;
  EXPECT_THROW(requireSoundLight(light), BadArgumentException);
  light = {};
  light.projector.T_reference_projector.linear() *= 2;
  EXPECT_THROW(requireSoundLight(light), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
