#include "scripted_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

template <typename Exception>
std::string
messageOf(const std::function<void()>& act)
{
  try {
    act();
  }
  catch (const Exception& exception) {
    return exception.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

TEST(CameraFaults, ACameraThatIsGivenTwiceIsRefused)
{
  ScriptedCameras desk;
  EXPECT_THAT(messageOf<BadArgumentException>([&] {
                CameraGrabber(pairRig(), {"left", "left"}, desk.opener());
              }),
              HasSubstr("left and left are refused: they are one camera"));
  EXPECT_EQ(desk.camera("left").opened, 0);
}

TEST(CameraFaults, CamerasThatGiveTheSameImageAreRefused)
{
  ScriptedCameras desk;
  desk.camera("right").image = desk.camera("left").image;
  EXPECT_THAT(messageOf<BadArgumentException>([&] {
                CameraGrabber(pairRig(), {"left", "right"}, desk.opener());
              }),
              HasSubstr("the reference camera, left, and the horizontal camera, right, "
                        "are refused: they give the same image"));
}

TEST(CameraFaults, CamerasInTheDarkAreNotTheSame)
{
  ScriptedCameras desk;
  const auto black = [](int) {
    CameraImage image = texturedImage(0);
    image.values.assign(image.values.size(), 0);
    return image;
  };
  desk.camera("left").image = desk.camera("right").image = black;
  EXPECT_NO_THROW(CameraGrabber(pairRig(), {"left", "right"}, desk.opener()));
}

TEST(CameraFaults, AnotherNumberOfCamerasIsRefused)
{
  ScriptedCameras desk;
  EXPECT_THAT(messageOf<BadArgumentException>([&] {
                CameraGrabber(pairRig(), {"left", "right", "top"}, desk.opener());
              }),
              HasSubstr("3 cameras are refused: the rig has 2"));
  TrinocularRig single = pairRig();
  single.baseline_horizontal = 0;
  EXPECT_THROW(CameraGrabber(single, {"left"}, desk.opener()), BadArgumentException);
  TrinocularRig wrong = pairRig();
  wrong.focal_length = 0;
  EXPECT_THROW(CameraGrabber(wrong, {"left", "right"}, desk.opener()),
               BadArgumentException);
}

TEST(CameraFaults, AnotherSizeIsRefused)
{
  ScriptedCameras desk;
  desk.camera("right").image = [](int) {
    return CameraImage{32, 24, 1, std::vector<std::uint8_t>(32 * 24, 7)};
  };
  const std::string message = messageOf<CameraException>([&] {
    CameraGrabber(pairRig(), {"left", "right"}, desk.opener());
  });
  EXPECT_THAT(message,
              HasSubstr("the horizontal camera, right: gives images of 32 x 24 pixels, "
                        "the rig has 64 x 48 pixels"));
}

TEST(CameraFaults, ASizeThatChangesEndsTheStream)
{
  ScriptedCameras desk;
  desk.camera("right").image = [](int i) {
    return i < 12 ? texturedImage(1)
                  : CameraImage{8, 8, 1, std::vector<std::uint8_t>(64, 7)};
  };
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::Unsupported);
  EXPECT_EQ(taken.size(), 0u);
}

TEST(CameraFaults, AnUnpluggedCameraIsNamedAndOpenedAgain)
{
  ScriptedCameras desk;
  desk.camera("right").images = 17 + 7 + 3; // the first shot, the second, half a third
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  shoot(grabber);
  EXPECT_EQ(taken.size(), 2u);
  shoot(grabber);
  std::string message;
  EXPECT_EQ(streamFaultOf(grabber, &message), CameraFault::Unplugged);
  EXPECT_THAT(message, HasSubstr("the horizontal camera, right: gives no more images"));
  EXPECT_EQ(taken.size(), 2u);

  desk.camera("right").images = 0;
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::Unplugged);

  desk.camera("right").images = 1000000; // plugged in again
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::None);
  EXPECT_EQ(taken.size(), 3u);
  EXPECT_EQ(taken.frames()[2]->number, 2u);
  EXPECT_EQ(desk.camera("left").opened, 3);
}

TEST(CameraFaults, ACameraThatGivesNoImageIsSilent)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setTimeout(0.2);
  desk.camera("left").blocks = true;
  const auto begin = std::chrono::steady_clock::now();
  shoot(grabber);
  std::string message;
  EXPECT_EQ(streamFaultOf(grabber, &message), CameraFault::Silent);
  EXPECT_THAT(message,
              HasSubstr("the reference camera, left: gave no image within 0.2 s"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
  desk.camera("left").blocks = false;
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::None);
}

TEST(CameraFaults, StopDoesNotWaitForASilentCamera)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setTimeout(600);
  const TakenFrames taken(grabber);
  grabber.start();
  while (taken.size() == 0)
    std::this_thread::yield();
  desk.camera("left").blocks = true;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const auto begin = std::chrono::steady_clock::now();
  grabber.stop();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  desk.camera("left").blocks = false;
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::None);
}

TEST(CameraFaults, ASceneThatNeverStandsStillIsAnError)
{
  ScriptedCameras desk;
  desk.camera("right").image = [](int i) { return texturedImage(1, i); };
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  grabber.setMaximumRetries(8);
  const TakenFrames taken(grabber);
  shoot(grabber);
  std::string message;
  EXPECT_EQ(streamFaultOf(grabber, &message), CameraFault::Moving);
  EXPECT_THAT(message,
              HasSubstr("the scene moves: two successive images of the "
                        "horizontal camera differ by "));
  EXPECT_THAT(message,
              HasSubstr(" grey levels, 4 are allowed, and it did not stand "
                        "still within 10 images"));
  EXPECT_EQ(taken.size(), 0u);
  EXPECT_EQ(grabber.getReport().moved, 9u);
  desk.camera("right").image = [](int) { return texturedImage(1); };
  shoot(grabber);
  EXPECT_EQ(taken.size(), 1u);
  EXPECT_EQ(desk.camera("right").opened, 1); // it was no fault of the camera
}

TEST(CameraFaults, IncompleteImagesArePassedOver)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  desk.camera("left").is_incomplete = true;
  shoot(grabber);
  EXPECT_EQ(streamFaultOf(grabber), CameraFault::Corrupt);
  EXPECT_EQ(grabber.getReport().broken, 11u);
  desk.camera("left").is_incomplete = false;
  shoot(grabber);
  EXPECT_EQ(taken.size(), 2u);
}

TEST(CameraFaults, ARecordingThatEndsWithinAShotIsAnError)
{
  ScriptedCameras desk;
  for (const char* const name : {"left", "right"}) {
    desk.camera(name).is_recording = true;
    desk.camera(name).images = 20;
  }
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const TakenFrames taken(grabber);
  shoot(grabber);
  shoot(grabber);
  std::string message;
  EXPECT_EQ(streamFaultOf(grabber, &message), CameraFault::Silent);
  EXPECT_THAT(message, HasSubstr("the recording ended"));
  EXPECT_EQ(taken.size(), 1u);
}

TEST(CameraFaults, AnExceptionOfACallbackIsKept)
{
  ScriptedCameras desk;
  CameraGrabber grabber(pairRig(), {"left", "right"}, desk.opener());
  const std::function<TrinocularGrabber::FrameCallback> fail =
      [](const TrinocularFrame::ConstPtr&) { throw std::runtime_error("full"); };
  grabber.registerCallback(fail);
  grabber.start();
  grabber.wait();
  EXPECT_THROW(std::rethrow_exception(grabber.getError()), std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
