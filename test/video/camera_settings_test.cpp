#include "scripted_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(CameraSettings, TheSizeOfTheRigIsRequested)
{
  ScriptedCameras desk;
  const CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  EXPECT_EQ(desk.camera("right").settings[VideoSetting::Width], image_width);
  EXPECT_EQ(desk.camera("right").settings[VideoSetting::Height], image_height);
}

TEST(CameraSettings, ExposureIsFixedAfterTheWarmUp)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  EXPECT_EQ(desk.camera("left").settings[VideoSetting::AutomaticExposure], 1);
  shoot(grabber);
  for (const char* const name : {"left", "right"}) {
    CameraScript& camera = desk.camera(name);
    EXPECT_EQ(camera.settings[VideoSetting::AutomaticExposure], 0);
    EXPECT_EQ(camera.changed_at[VideoSetting::AutomaticExposure], 10);
    EXPECT_EQ(camera.settings[VideoSetting::Exposure], 0.02); // what it had by then
    EXPECT_EQ(camera.changed_at[VideoSetting::Exposure], 10);
    EXPECT_EQ(camera.settings[VideoSetting::AutomaticWhiteBalance], 0);
    EXPECT_EQ(camera.settings[VideoSetting::AutomaticFocus], 0);
    EXPECT_EQ(camera.settings.count(VideoSetting::Gain), 0u);
  }
  const CameraGrabberReport report = grabber.getReport();
  EXPECT_THAT(report.remarks, IsEmpty());
  ASSERT_EQ(report.cameras.size(), 2u);
  EXPECT_EQ(report.cameras[0].device, "left");
  EXPECT_TRUE(report.cameras[0].is_exposure_fixed);
  EXPECT_EQ(report.cameras[0].exposure, 0.02);
  EXPECT_EQ(report.cameras[0].frames_per_second, 30);
}

TEST(CameraSettings, ExposureAndGainAreThoseOfTheUser)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setExposure(0.01);
  grabber.setGain(16);
  shoot(grabber);
  EXPECT_EQ(desk.camera("right").settings[VideoSetting::Exposure], 0.01);
  EXPECT_EQ(desk.camera("right").settings[VideoSetting::Gain], 16);
  grabber.setExposure(0.005); // takes effect with the next shot, without a warm-up
  shoot(grabber);
  EXPECT_EQ(desk.camera("right").settings[VideoSetting::Exposure], 0.005);
  EXPECT_EQ(desk.camera("right").grabbed, 10 + 7 + 7);
  grabber.setAutomaticExposure(true);
  shoot(grabber);
  EXPECT_EQ(desk.camera("right").settings[VideoSetting::AutomaticExposure], 1);
  EXPECT_FALSE(grabber.getReport().cameras[0].is_exposure_fixed);
  EXPECT_THAT(grabber.getReport().remarks, IsEmpty());
}

TEST(CameraSettings, ACameraThatFixesNothingIsTold)
{
  ScriptedCameras desk;
  desk.camera("right").refused = {VideoSetting::AutomaticExposure};
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  EXPECT_EQ(taken.size(), 1u);
  EXPECT_THAT(grabber.getReport().remarks,
              ElementsAre("right: its exposure cannot be fixed; it may change between "
                          "shots"));
  EXPECT_FALSE(grabber.getReport().cameras[1].is_exposure_fixed);
}

TEST(CameraSettings, AValueThatACameraRefusesIsAnError)
{
  ScriptedCameras desk;
  desk.camera("right").refused = {VideoSetting::Gain};
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setGain(3);
  shoot(grabber);
  std::string message;
  EXPECT_EQ(streamFaultOf(grabber, &message), CameraFault::Unsupported);
  EXPECT_THAT(message, HasSubstr("right: refuses gain = 3"));
}

TEST(CameraSettings, AFormatIsSetWhenTheCamerasAreOpened)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setPixelFormat("MJPG");
  EXPECT_EQ(grabber.getPixelFormat(), "MJPG");
  shoot(grabber);
  EXPECT_EQ(desk.camera("left").settings[VideoSetting::PixelFormat], 0x47504A4D);
  EXPECT_EQ(desk.camera("left").opened, 2);
  grabber.setPixelFormat("MJPG");
  shoot(grabber);
  EXPECT_EQ(desk.camera("left").opened, 2);
}

TEST(CameraSettings, NonsenseIsRefused)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const double nan = std::nan("");
  EXPECT_THROW(grabber.setFramesPerSecond(0), BadArgumentException);
  EXPECT_THROW(grabber.setWarmUpFrames(10001), BadArgumentException);
  EXPECT_THROW(grabber.setDiscardedFrames(1001), BadArgumentException);
  EXPECT_THROW(grabber.setMaximumChange(0), BadArgumentException);
  EXPECT_THROW(grabber.setMaximumChange(nan), BadArgumentException);
  EXPECT_THROW(grabber.setMaximumRetries(100001), BadArgumentException);
  EXPECT_THROW(grabber.setTimeout(0), BadArgumentException);
  EXPECT_THROW(grabber.setPixelFormat("MJPEG"), BadArgumentException);
  EXPECT_THROW(grabber.setPixelFormat("MJ\n "), BadArgumentException);
  EXPECT_THROW(grabber.setExposure(0), BadArgumentException);
  EXPECT_THROW(grabber.setGain(nan), BadArgumentException);
  EXPECT_EQ(grabber.getWarmUpFrames(), 10u);
  EXPECT_EQ(grabber.getDiscardedFrames(), 5u);
  EXPECT_EQ(grabber.getMaximumRetries(), 60u);
  EXPECT_EQ(grabber.getMaximumChange(), 4);
  EXPECT_EQ(grabber.getTimeout(), 5);
  EXPECT_EQ(grabber.getPixelFormat(), "");
}

} // namespace
} // namespace pcl::acmap::test
