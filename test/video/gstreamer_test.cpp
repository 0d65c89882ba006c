#include "thrown_faults.h"

#include <pcl/video/camera_grabber.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** \brief A pipeline that shows an image of its own.
 * \param[in] images number of images before it ends */
std::string
pipeline(const std::string& picture, int images, int width = 160)
{
  return "videotestsrc pattern=" + picture + " num-buffers=" + std::to_string(images) +
         " ! video/x-raw,format=BGR,framerate=30/1,height=120,width=" +
         std::to_string(width) + " ! videoconvert ! appsink";
}

class GStreamer : public testing::Test {
protected:
  void
  SetUp() override
  {
    try {
      openVideo(pipeline("smpte75", 2));
    }
    catch (const CameraException& exception) {
      GTEST_SKIP() << "GStreamer has no test pictures: " << exception.what();
    }
    rig_.width = 160;
    rig_.height = 120;
    rig_.focal_length = 130;
    rig_.center_x = 79.5;
    rig_.center_y = 59.5;
    rig_.baseline_vertical = 0;
  }

  TrinocularRig rig_;
};

TEST_F(GStreamer, TwoPipelinesAreAPairOfCameras)
{
  CameraGrabber grabber(rig_, {pipeline("smpte75", 1000), pipeline("circular", 1000)});
  TrinocularFrame::ConstPtr taken;
  const std::function<TrinocularGrabber::FrameCallback> take =
      [&](const TrinocularFrame::ConstPtr& frame) { taken = frame; };
  grabber.registerCallback(take);
  grabber.trigger();
  grabber.wait();
  if (grabber.getError())
    std::rethrow_exception(grabber.getError());
  ASSERT_TRUE(taken);
  const CameraImage& image = taken->image(RigCamera::Reference);
  EXPECT_EQ(image.channels, 3);
  // the second bar of the SMPTE picture is yellow
  const std::size_t yellow = 3 * (160 * 20 + 160 * 3 / 14);
  EXPECT_GT(image.values[yellow], 150);
  EXPECT_GT(image.values[yellow + 1], 150);
  EXPECT_LT(image.values[yellow + 2], 60);
  EXPECT_FALSE(grabber.getReport().cameras[0].is_recording);
  EXPECT_THAT(grabber.getReport().remarks[0], HasSubstr("exposure cannot be fixed"));
}

TEST_F(GStreamer, APipelineThatEndsIsAnUnpluggedCamera)
{
  CameraGrabber grabber(rig_, {pipeline("smpte75", 1000), pipeline("circular", 14)});
  grabber.trigger();
  grabber.wait();
  std::string message;
  EXPECT_EQ(streamFaultOf(grabber, &message), CameraFault::Unplugged);
  EXPECT_THAT(message, HasSubstr("pattern=circular"));
}

TEST_F(GStreamer, TheSamePictureIsOneCamera)
{
  EXPECT_THROW(CameraGrabber(rig_, {pipeline("smpte75", 9), pipeline("smpte75", 8)}),
               BadArgumentException);
}

TEST_F(GStreamer, APipelineOfNonsenseIsRefused)
{
  EXPECT_THAT([&] { openVideo("nosuchsrc ! appsink"); },
              testing::ThrowsMessage<CameraException>(
                  HasSubstr("GStreamer does not accept this pipeline")));
}

} // namespace
} // namespace pcl::acmap::test
