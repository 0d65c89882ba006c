#include "temporary_folder.h"
#include "video_writer.h"

#include <pcl/core/image_file.h>
#include <pcl/video/camera_grabber.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr int width = 160;
constexpr int height = 120;

CameraImage
image(int seed, int channels = 3)
{
  CameraImage image{width, height, channels, {}};
  for (int i = 0; i < width * height * channels; ++i)
    image.values.push_back(static_cast<std::uint8_t>((i * (seed + 3) / 7) % 251));
  return image;
}

TrinocularRig
smallRig()
{
  TrinocularRig rig;
  rig.width = width;
  rig.height = height;
  rig.focal_length = 130;
  rig.center_x = 79.5;
  rig.center_y = 59.5;
  rig.baseline_vertical = 0;
  return rig;
}

/** \brief Writes a video that always shows the same image. */
std::string
writeStill(const TemporaryFolder& folder,
           const std::string& name,
           int seed,
           int images,
           int scale = 1)
{
  VideoFile video(folder.path(name), width * scale, height * scale);
  CameraImage shown = image(seed);
  if (scale > 1) {
    shown.width *= scale;
    shown.height *= scale;
    shown.values.resize(shown.values.size() * static_cast<std::size_t>(scale * scale),
                        static_cast<std::uint8_t>(seed));
  }
  for (int i = 0; i < images; ++i)
    video.write(shown);
  return folder.path(name);
}

TEST(VideoFiles, AreStreamedToTheirEnd)
{
  const TemporaryFolder folder;
  CameraGrabber grabber(
      smallRig(),
      {writeStill(folder, "a.mkv", 1, 45), writeStill(folder, "b.mkv", 2, 40)});
  std::vector<TrinocularFrame::ConstPtr> frames;
  const std::function<TrinocularGrabber::FrameCallback> take =
      [&](const TrinocularFrame::ConstPtr& frame) { frames.push_back(frame); };
  grabber.registerCallback(take);
  grabber.start();
  grabber.wait();
  EXPECT_FALSE(grabber.getError());
  ASSERT_EQ(frames.size(), 40u - 10 - 1); // without warm-up, and the first to compare
  EXPECT_TRUE(frames[0]->image(RigCamera::Reference) == image(1));
  EXPECT_TRUE(frames[0]->image(RigCamera::Horizontal) == image(2));
  EXPECT_NEAR(static_cast<double>(frames[0]->stamp), 11e6 / 30, 2); // position
  EXPECT_NEAR(static_cast<double>(frames[1]->stamp), 12e6 / 30, 2);
  const CameraGrabberReport report = grabber.getReport();
  EXPECT_TRUE(report.cameras[0].is_recording);
  EXPECT_DOUBLE_EQ(report.cameras[0].frames_per_second, 30);
  EXPECT_TRUE(report.remarks.empty()); // the exposure of a recording cannot change
}

TEST(VideoFiles, ImagesWithNumbersAreAVideo)
{
  const TemporaryFolder folder;
  for (int i = 0; i < 20; ++i)
    for (const int seed : {1, 2}) {
      const std::vector<std::uint8_t> png =
          encodePng(RgbImage{width, height, image(seed).values});
      char name[32];
      std::snprintf(name, sizeof(name), "%d_%04d.png", seed, i);
      folder.write(name, std::string(png.begin(), png.end()));
    }
  CameraGrabber grabber(smallRig(),
                        {folder.path("1_%04d.png"), folder.path("2_%04d.png")});
  std::size_t frames = 0;
  const std::function<TrinocularGrabber::FrameCallback> take =
      [&](const TrinocularFrame::ConstPtr& frame) {
        ++frames;
        EXPECT_TRUE(frame->image(RigCamera::Horizontal) == image(2));
      };
  grabber.registerCallback(take);
  grabber.start();
  grabber.wait();
  EXPECT_FALSE(grabber.getError());
  EXPECT_EQ(frames, 20u - 10 - 1);
}

template <typename Exception>
std::string
messageOf(const std::vector<std::string>& devices)
{
  try {
    const CameraGrabber grabber(smallRig(), devices);
  }
  catch (const Exception& exception) {
    return exception.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

TEST(VideoFiles, InvalidOnesAreRefused)
{
  const TemporaryFolder folder;
  const std::string good = writeStill(folder, "good.mkv", 1, 20);
  const std::string text = folder.write("text.mkv", "this is no video");
  const std::string large = writeStill(folder, "large.mkv", 2, 20, 2);
  std::filesystem::copy(good, folder.path("copy.mkv"));
  EXPECT_THAT(messageOf<InputFileException>({good, text}),
              HasSubstr("text.mkv: is no video that OpenCV can read"));
  EXPECT_THAT(messageOf<InputFileException>({good, folder.path("none_%04d.png")}),
              HasSubstr("none_%04d.png: there are no such images"));
  EXPECT_THAT(messageOf<InputFileException>({good, folder.path("")}),
              HasSubstr("is a folder"));
  EXPECT_THAT(messageOf<CameraException>({good, folder.path("none.mkv")}),
              HasSubstr("none.mkv: there is no such camera"));
  EXPECT_THAT(messageOf<CameraException>({good, large}),
              HasSubstr("gives images of 320 x 240 pixels, the rig has 160 x 120"));
  EXPECT_THAT(messageOf<BadArgumentException>({good, good}),
              HasSubstr("they are one camera"));
  EXPECT_THAT(messageOf<BadArgumentException>({good, folder.path("copy.mkv")}),
              HasSubstr("they give the same image"));
  EXPECT_THAT(messageOf<CameraException>({good, "/dev/null"}),
              HasSubstr("/dev/null: cannot be opened: is it a camera"));
}

} // namespace
} // namespace pcl::acmap::test
