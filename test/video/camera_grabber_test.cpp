#include "scripted_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** \brief The scene of both cameras moves while the number of the image is in an
 * interval. */
void
moveWithin(ScriptedCameras& desk, int begin, int end)
{
  int seed = 0;
  for (const char* const name : {"left", "right"}) {
    desk.camera(name).image = [=](int i) {
      return texturedImage(seed, std::min(std::max(i - begin, 0), end - begin));
    };
    ++seed;
  }
}

TEST(CameraGrabber, TakesAShotOfAPair)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"right", "left"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::None);
  const auto frames = taken.frames();
  ASSERT_EQ(frames.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(frames[i]->number, i);
    EXPECT_EQ(frames[i]->observation, static_cast<int>(i));
    EXPECT_EQ(frames[i]->pattern, TrinocularFrame::no_pattern);
    EXPECT_TRUE(frames[i]->image(RigCamera::Reference) == texturedImage(1));
    EXPECT_TRUE(frames[i]->image(RigCamera::Horizontal) == texturedImage(0));
    EXPECT_TRUE(frames[i]->image(RigCamera::Vertical).empty());
  }
  EXPECT_EQ(frames[1]->stamp - frames[0]->stamp, 7u * 33333u);
  grabber.rewind();
  shoot(grabber);
  EXPECT_EQ(taken.frames().back()->number, 0u);
  EXPECT_EQ(grabber.getReport().frames, 3u);
  EXPECT_EQ(grabber.getReport().largest_change, 0);
}

TEST(CameraGrabber, TakesAShotOfThree)
{
  ScriptedCameras desk;
  TrinocularRig rig = pairRig();
  rig.baseline_vertical = -0.1;
  CameraGrabber grabber(rig, {"right", "left", "top"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_TRUE(taken.frames()[0]->image(RigCamera::Vertical) == texturedImage(2));
}

TEST(CameraGrabber, ARigMayHaveItsNeighbourAbove)
{
  ScriptedCameras desk;
  TrinocularRig rig = pairRig();
  rig.baseline_vertical = -0.1;
  rig.baseline_horizontal = 0;
  CameraGrabber grabber(rig, {"left", "top"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_TRUE(taken.frames()[0]->image(RigCamera::Horizontal).empty());
  EXPECT_TRUE(taken.frames()[0]->image(RigCamera::Vertical) == texturedImage(2));
}

TEST(CameraGrabber, ThrowsAwayTheFirstImagesAndTheBufferedOnes)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setWarmUpFrames(20);
  grabber.setDiscardedFrames(3);
  const TakenFrames taken(grabber);
  shoot(grabber);
  EXPECT_EQ(taken.frames().back()->stamp, 33333u * (20 + 3 + 2));
  shoot(grabber);
  EXPECT_EQ(taken.frames().back()->stamp, 33333u * (20 + 2 * (3 + 2)));
  EXPECT_EQ(grabber.getReport().discarded, 20u + 2 * 3);
}

TEST(CameraGrabber, WaitsUntilTheSceneStandsStill)
{
  ScriptedCameras desk;
  moveWithin(desk, 0, 40);
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  ASSERT_EQ(streamFaultOf(grabber), CameraFault::None);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_TRUE(taken.frames()[0]->image(RigCamera::Reference) == texturedImage(0, 40));
  const CameraGrabberReport report = grabber.getReport();
  EXPECT_EQ(report.moved, 40u - 10 - 5);
  ASSERT_EQ(report.remarks.size(), 1u);
  EXPECT_THAT(report.remarks[0], HasSubstr("frame 0: the scene moved for 25 images"));
}

TEST(CameraGrabber, MotionBeforeTheOneOfACameraIsEnough)
{
  ScriptedCameras desk;
  desk.camera("right").image = [](int i) { return texturedImage(1, std::min(i, 30)); };
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_TRUE(taken.frames()[0]->image(RigCamera::Horizontal) == texturedImage(1, 30));
}

TEST(CameraGrabber, TheCheckCanBeSwitchedOff)
{
  ScriptedCameras desk;
  moveWithin(desk, 0, 1000000);
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setMaximumChange(255);
  const TakenFrames taken(grabber);
  shoot(grabber);
  EXPECT_EQ(taken.size(), 1u);
}

TEST(CameraGrabber, AStreamGivesOnlyStillFrames)
{
  ScriptedCameras desk;
  for (const char* const name : {"left", "right"}) {
    desk.camera(name).images = 200;
    desk.camera(name).is_recording = true;
  }
  moveWithin(desk, 60, 160);
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  grabber.start();
  grabber.wait();
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::None);
  // 10 for the warm-up; the first of the others only to compare
  EXPECT_EQ(taken.size(), 200u - 10 - 1 - 100);
  EXPECT_EQ(grabber.getReport().moved, 100u);
  for (const auto& frame : taken.frames()) {
    const CameraImage& image = frame->image(RigCamera::Reference);
    EXPECT_TRUE(image == texturedImage(0) || image == texturedImage(0, 100));
  }
}

TEST(CameraGrabber, AStreamHasTheNearestRate)
{
  ScriptedCameras desk;
  for (const char* const name : {"left", "right"}) {
    desk.camera(name).images = 100;
    desk.camera(name).is_recording = true;
  }
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  EXPECT_FLOAT_EQ(grabber.getFramesPerSecond(), 30);
  grabber.setFramesPerSecond(7);
  EXPECT_FLOAT_EQ(grabber.getFramesPerSecond(), 7.5);
  const TakenFrames taken(grabber);
  grabber.start();
  grabber.wait();
  ASSERT_EQ(taken.size(), (100u - 10) / 4);
  EXPECT_EQ(taken.frames()[1]->stamp - taken.frames()[0]->stamp, 4u * 33333u);
  EXPECT_NEAR(grabber.getReport().frames_per_second, 7.5, 0.01);
}

TEST(CameraGrabber, AStreamEndsByStop)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  grabber.start();
  while (taken.size() < 5)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  grabber.stop();
  const std::size_t frames = taken.size();
  EXPECT_FALSE(grabber.isRunning());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(taken.size(), frames);
  shoot(grabber);
  EXPECT_EQ(taken.size(), frames + 1);
}

TEST(CameraGrabber, MayBeStoppedFromItsCallback)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const std::function<TrinocularGrabber::FrameCallback> stop =
      [&](const TrinocularFrame::ConstPtr&) { grabber.stop(); };
  grabber.registerCallback(stop);
  grabber.start();
  grabber.wait();
  EXPECT_EQ(grabber.getReport().frames, 1u);
}

} // namespace
} // namespace pcl::acmap::test
