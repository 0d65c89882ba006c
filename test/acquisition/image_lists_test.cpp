#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/rig_of_images.h>
#include <pcl/core/image_file.h>
#include <pcl/core/rig_calibration.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/** Two shots of three cameras, as PNG files. */
class ImageLists : public testing::Test {
protected:
  ImageLists()
  {
    for (auto* const list : {&lists_.reference, &lists_.horizontal, &lists_.vertical})
      for (int pattern = 0; pattern < 2; ++pattern)
        list->push_back(writePng(
            noisyImage(16, 12, 3, static_cast<std::uint64_t>(folder_.count()))));
  }

  std::string
  writePng(const CameraImage& image) const
  {
    const auto bytes = encodePng(RgbImage{image.width, image.height, image.values});
    return folder_.write(std::to_string(folder_.count()) + ".png",
                         {bytes.begin(), bytes.end()});
  }

  /** Frame 1 with \a file as the image of the reference camera. */
  TrinocularFrame::Ptr
  frameWith(const std::string& file)
  {
    lists_.reference[1] = folder_.write("image", file);
    return TrinocularFileGrabber(lists_, rig_).frame(1);
  }

  std::string
  faultWith(const std::string& file)
  {
    return faultOfRunning<InputFileException>([&] { frameWith(file); });
  }

  std::string
  refusal() const
  {
    return faultOfRunning<BadArgumentException>(
        [&] { TrinocularFileGrabber(lists_, rig_); });
  }

  TemporaryFolder folder_;
  TrinocularImageLists lists_;
  TrinocularRig rig_ = rigOf(16, 12);
};

TEST_F(ImageLists, AreOneObservation)
{
  const TrinocularFileGrabber grabber(lists_, rig_);
  ASSERT_EQ(grabber.frames(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    const TrinocularFrame::Ptr frame = grabber.frame(i);
    EXPECT_EQ(frame->number, i);
    EXPECT_EQ(frame->observation, 0);
    EXPECT_EQ(frame->pattern, int(i));
    EXPECT_EQ(frame->images[0].channels, 3);
    EXPECT_EQ(frame->images[0].values, loadRgbImage(lists_.reference[i]).values);
    EXPECT_EQ(frame->images[1].values, loadRgbImage(lists_.horizontal[i]).values);
    EXPECT_EQ(frame->images[2].values, loadRgbImage(lists_.vertical[i]).values);
  }
  EXPECT_TRUE(grabber.getReport().remarks.empty());
}

TEST_F(ImageLists, NameTheFrameOfAFaultyImage)
{
  lists_.horizontal[1] = writePng(noisyImage(20, 12, 3, 1));
  const TrinocularFileGrabber grabber(lists_, rig_);
  const auto fault = [&] {
    return faultOfRunning<InputFileException>([&] { grabber.frame(1); });
  };
  const std::string begin = "frame 1: horizontal camera: " + lists_.horizontal[1];
  EXPECT_EQ(fault(), begin + ": 20 x 12 pixels, the rig has 16 x 12");
  EXPECT_THAT(grabber.getReport().broken, ElementsAre(1));
  EXPECT_THAT(grabber.getReport().remarks, ElementsAre(fault()));
  std::ofstream(lists_.horizontal[1]) << "no image";
  EXPECT_THAT(fault(), HasSubstr(begin + ": is no PNG"));
  damage(lists_.reference[1], -20);
  EXPECT_THAT(fault(), HasSubstr("frame 1: reference camera: " + lists_.reference[1]));
  EXPECT_NO_THROW(grabber.frame(0));
}

TEST_F(ImageLists, NameTheFrameThatIsMissingOrDoubled)
{
  const TrinocularImageLists sound = lists_;
  lists_.vertical.pop_back();
  EXPECT_EQ(refusal(), "frame 1: vertical camera: 1 images, 2 are needed");
  lists_ = sound;
  lists_.horizontal.push_back("more.png");
  EXPECT_EQ(refusal(), "frame 2: horizontal camera: 3 images, 2 are needed");
  lists_ = sound;
  lists_.vertical[1] = lists_.vertical[0];
  EXPECT_EQ(refusal(),
            "frame 1: vertical camera: " + lists_.vertical[0] +
                " was there before: frame 0: vertical camera");
}

TEST_F(ImageLists, AreOfTheRigsCameras)
{
  rig_.baseline_vertical = 0;
  EXPECT_EQ(refusal(), "frame 0: vertical camera: 2 images, 0 are needed");
  lists_.vertical.clear();
  EXPECT_TRUE(TrinocularFileGrabber(lists_, rig_).frame(0)->images[2].empty());
  rig_.baseline_vertical = 0.1;
  EXPECT_EQ(refusal(), "frame 0: vertical camera: 0 images, 2 are needed");
}

TEST_F(ImageLists, TellOfSaturatedAndBlackImages)
{
  lists_.horizontal[0] =
      writePng({16, 12, 3, std::vector<std::uint8_t>(576, std::uint8_t{255})});
  lists_.reference[1] =
      writePng({16, 12, 3, std::vector<std::uint8_t>(576, std::uint8_t{2})});
  const TrinocularFileGrabber grabber(lists_, rig_);
  grabber.frame(0);
  grabber.frame(1);
  EXPECT_THAT(
      grabber.getReport().remarks,
      ElementsAre("frame 0: horizontal camera: 100 % of its values are saturated",
                  "frame 1: reference camera: 100 % of its values are black"));
}

TEST_F(ImageLists, ReadBinaryPgmAndPpm)
{
  const CameraImage gray = noisyImage(16, 12, 1, 7);
  const std::string gray_values(gray.values.begin(), gray.values.end());
  const TrinocularFrame::Ptr of_gray = frameWith("P5\n16 12\n255\n" + gray_values);
  ASSERT_EQ(of_gray->images[0].values.size(), 576U);
  for (std::size_t i = 0; i < 576; ++i)
    ASSERT_EQ(of_gray->images[0].values[i], gray.values[i / 3]);
  const CameraImage color = noisyImage(16, 12, 3, 8);
  const std::string color_values(color.values.begin(), color.values.end());
  EXPECT_TRUE(
      frameWith("P6 16\t12 # by a camera\n#P5 7\n255\r" + color_values)->images[0] ==
      color);
}

TEST_F(ImageLists, RefuseUglyPgmAndPpm)
{
  const std::string values(192, 'v');
  EXPECT_EQ(faultWith("P5 16 12 255\n" + values), "");
  EXPECT_THAT(faultWith("P5 16 11 255\n" + values.substr(16)), HasSubstr("16 x 11"));
  for (const std::string& file : {"P5 16 12 255\n" + values + "v",
                                  "P6 16 12 255\n" + values,
                                  std::string("P5 16 12 65535\n") + values,
                                  std::string("P5 16"),
                                  std::string("P")})
    EXPECT_THAT(
        faultWith(file),
        testing::AllOf(HasSubstr("frame 1: reference camera"), HasSubstr("image: ")))
        << file;
}

TEST_F(ImageLists, HaveTheirCamerasInACalibration)
{
  const std::string rig = folder_.path("rig.yaml");
  saveTrinocularRig(rig, rig_);
  const CalibratedRig all = loadRigOfImages({rig}, lists_);
  EXPECT_EQ(all.rig.baseline_horizontal, rig_.baseline_horizontal);
  EXPECT_EQ(all.rig.baseline_vertical, rig_.baseline_vertical);
  EXPECT_FALSE(all.cameras);
  TrinocularImageLists pair = lists_;
  pair.vertical.clear();
  EXPECT_EQ(loadRigOfImages({rig}, pair).rig.baseline_vertical, 0);

  rig_.baseline_vertical = 0;
  saveTrinocularRig(rig, rig_);
  EXPECT_THAT(
      faultOfRunning<BadArgumentException>([&] { loadRigOfImages({rig}, lists_); }),
      HasSubstr("has no vertical camera"));
  EXPECT_THROW(loadRigOfImages({rig}, {}), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
