#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

class SessionFindings : public testing::Test {
protected:
  std::string
  frameFile(int number) const
  {
    return session_ + "/frame_00000" + std::to_string(number) + ".acf";
  }

  std::string
  openingFault(const std::string& folder) const
  {
    return faultOfRunning<InputFileException>([&] { TrinocularFileGrabber g(folder); });
  }

  TemporaryFolder folder_;
  std::string session_ = folder_.path("session");
  TrinocularRig rig_ = rigOf(16, 12);
};

TEST_F(SessionFindings, NoneInASoundSession)
{
  recordSession(session_, rig_, 6);
  const TrinocularFileGrabber grabber(session_);
  for (std::size_t i = 0; i < grabber.frames(); ++i)
    grabber.frame(i);
  const TrinocularFileReport report = grabber.getReport();
  EXPECT_EQ(report.frames, 6U);
  EXPECT_TRUE(report.is_finished);
  EXPECT_THAT(report.remarks, IsEmpty());
}

TEST_F(SessionFindings, MissingShotsAndFrames)
{
  recordSession(session_, rig_, 8); // the third observation lacks its last pattern
  fs::remove(frameFile(3));         // the second one has no shot without a pattern
  const TrinocularFileReport report = TrinocularFileGrabber(session_).getReport();
  EXPECT_THAT(report.missing, ElementsAre(TrinocularShot{1, -1}, TrinocularShot{2, 1}));
  EXPECT_THAT(report.remarks,
              ElementsAre(HasSubstr("has 7 frames, session.yaml tells of 8"),
                          "frame 3 is missing",
                          "the shot of observation 1 without a pattern is missing, "
                          "after frame 2",
                          "the shot of observation 2 under pattern 1 is missing, "
                          "after frame 7"));
}

TEST_F(SessionFindings, ShotsMissingAtTheBeginningAndBetween)
{
  recordSession(session_, rig_, 6);
  fs::remove(frameFile(0));
  fs::remove(frameFile(2));
  fs::remove(frameFile(3)); // now no observation has a shot without a pattern
  const TrinocularFileReport report = TrinocularFileGrabber(session_).getReport();
  EXPECT_THAT(report.missing, ElementsAre(TrinocularShot{0, 1}));
  EXPECT_THAT(report.remarks,
              ElementsAre(HasSubstr("has 3 frames"),
                          "frame 0 is missing",
                          "frames 2 to 3 are missing",
                          "the shot of observation 0 under pattern 1 is missing, after "
                          "frame 1"));
  saveTrinocularFrame(frameFile(6), frameOf(rig_, 6, 2, -1));
  EXPECT_THAT(TrinocularFileGrabber(session_).getReport().remarks,
              Contains("the shot of observation 0 without a pattern is missing, before "
                       "frame 1"));
}

TEST_F(SessionFindings, PatternsThatNeverComeAgainFillNoMemory)
{
  TrinocularRecorder recorder(session_, rigOf(1, 1));
  for (std::int32_t i = 0; i < 60; ++i)
    recorder.record(frameOf(rigOf(1, 1), static_cast<std::uint64_t>(i), i, i));
  const TrinocularFileReport report = TrinocularFileGrabber(session_).getReport();
  EXPECT_EQ(report.missing.size(), 1000U);
  EXPECT_EQ(report.remarks.back(), "2540 more shots are missing");
}

TEST_F(SessionFindings, DoubledShots)
{
  recordSession(session_, rig_, 6);
  saveTrinocularFrame(frameFile(8), frameOf(rig_, 8, 1, 0));
  const TrinocularFileReport report = TrinocularFileGrabber(session_).getReport();
  EXPECT_THAT(report.doubled, ElementsAre(8));
  EXPECT_THAT(report.remarks,
              Contains("frame 8: the shot of observation 1 under pattern 0 was there "
                       "before, as frame 4"));
}

TEST_F(SessionFindings, UnfinishedSessionsAreRead)
{
  recordSession(session_, rig_, 6);
  fs::remove(session_ + "/session.yaml");
  std::ofstream(session_ + "/.frame_000006.acf.tmp-1-2") << "half a frame";
  const TrinocularFileGrabber grabber(session_);
  EXPECT_EQ(grabber.frames(), 6U);
  EXPECT_FALSE(grabber.getReport().is_finished);
  EXPECT_THAT(grabber.getReport().remarks, ElementsAre(HasSubstr("was not finished")));
}

TEST_F(SessionFindings, BrokenHeadersAreNamedAtOnce)
{
  recordSession(session_, rig_, 6);
  damage(frameFile(2), 0);
  fs::resize_file(frameFile(4), 200);
  const TrinocularFileReport report = TrinocularFileGrabber(session_).getReport();
  EXPECT_THAT(report.broken, ElementsAre(2, 4));
  EXPECT_THAT(report.remarks, Contains(HasSubstr("frame 4: is truncated")));
}

TEST_F(SessionFindings, DamagedImagesAreNamedOnceTheyAreRead)
{
  recordSession(session_, rig_, 6);
  damage(frameFile(2), -40); // inside the last image: the header remains valid
  const TrinocularFileGrabber grabber(session_);
  EXPECT_THAT(grabber.getReport().remarks, IsEmpty());
  EXPECT_THAT(faultOfRunning<InputFileException>([&] { grabber.frame(2); }),
              HasSubstr("frame 2: its checksum is wrong"));
  EXPECT_THAT(grabber.getReport().broken, ElementsAre(2));
  EXPECT_THAT(grabber.getReport().remarks,
              ElementsAre(HasSubstr("frame 2: its checksum is wrong")));
}

TEST_F(SessionFindings, ImagesOfDifferentSizes)
{
  recordSession(session_, rig_, 3);
  constexpr std::size_t width_place = 60; // offset in a frame file of the horizontal
                                          // image's width
  std::string bytes = contentOf(frameFile(1));
  bytes[width_place] = 15;
  std::ofstream(frameFile(1), std::ios::binary) << bytes;
  EXPECT_THAT(TrinocularFileGrabber(session_).getReport().remarks,
              Contains(HasSubstr("frame 1: horizontal camera: 15 x 12 pixels, the "
                                 "reference has 16 x 12")));
}

TEST_F(SessionFindings, RigsOfAnotherSizeOrWithOtherCameras)
{
  recordSession(session_, rig_, 3);
  const auto remarksUnder = [&](const TrinocularRig& rig) {
    saveTrinocularRig(session_ + "/rig.yaml", rig);
    return TrinocularFileGrabber(session_).getReport().remarks;
  };
  EXPECT_THAT(remarksUnder(rigOf(640, 480)),
              ElementsAre(HasSubstr("frame 0: reference camera: 16 x 12 pixels, the "
                                    "rig has 640 x 480"),
                          HasSubstr("frame 1: reference camera: 16 x 12"),
                          HasSubstr("frame 2: reference camera: 16 x 12")));
  TrinocularRig fewer = rig_;
  fewer.baseline_horizontal = 0;
  EXPECT_THAT(
      remarksUnder(fewer),
      Contains(HasSubstr("frame 2: horizontal camera: has an image, the rig has "
                         "no such camera")));
  recordSession(folder_.path("fewer"), fewer, 3);
  saveTrinocularRig(folder_.path("fewer/rig.yaml"), rig_);
  const TrinocularFileGrabber grabber(folder_.path("fewer"));
  EXPECT_THAT(grabber.getReport().broken, ElementsAre(0, 1, 2));
  EXPECT_THAT(faultOfRunning<InputFileException>([&] { grabber.frame(1); }),
              HasSubstr("frame 1: horizontal camera: has no image, the rig has such a "
                        "camera"));
}

TEST_F(SessionFindings, FramesOfAnotherRigOrPlace)
{
  recordSession(session_, rig_, 3);
  saveTrinocularFrame(frameFile(3), frameOf(rigOf(20, 12), 3, 1, 0));
  fs::copy(frameFile(1), frameFile(5));
  const TrinocularFileGrabber grabber(session_);
  EXPECT_THAT(grabber.getReport().broken, ElementsAre(3, 5));
  EXPECT_THAT(faultOfRunning<InputFileException>([&] { grabber.frame(3); }),
              HasSubstr("frame 3: reference camera: 20 x 12 pixels, the rig has 16 x"));
  EXPECT_THAT(faultOfRunning<InputFileException>([&] { grabber.frame(4); }),
              HasSubstr("frame 1: stands in the file of frame 5"));
}

TEST_F(SessionFindings, SaturatedAndBlackImages)
{
  recordSession(session_, rig_, 3);
  TrinocularFrame frame = frameOf(rig_, 3, 1, -1);
  auto& bright = frame.image(RigCamera::Horizontal).values;
  std::fill_n(bright.begin(), bright.size() / 5, 255);
  auto& full = frame.image(RigCamera::Vertical).values;
  std::fill(full.begin(), full.end(), 255);
  saveTrinocularFrame(frameFile(3), frame);
  frame = frameOf(rig_, 4, 1, 0);
  auto& dark = frame.image(RigCamera::Vertical).values;
  std::fill(dark.begin(), dark.end() - 1, 3);
  saveTrinocularFrame(frameFile(4), frame);
  frame = frameOf(rig_, 5, 1, 1);
  auto& little = frame.image(RigCamera::Reference).values;
  std::fill_n(little.begin(), little.size() / 20, 255);
  saveTrinocularFrame(frameFile(5), frame);

  const TrinocularFileGrabber grabber(session_);
  EXPECT_THAT(grabber.getReport().saturated, IsEmpty()) << "not read yet";
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < grabber.frames(); ++i)
      grabber.frame(i);
  const TrinocularFileReport report = grabber.getReport();
  EXPECT_THAT(report.saturated, ElementsAre(3));
  EXPECT_THAT(report.black, ElementsAre(4));
  EXPECT_THAT(report.remarks,
              Contains("frame 3: horizontal camera: 20 % of its values are saturated, "
                       "vertical camera: 100 % of its values are saturated"));
  EXPECT_THAT(report.remarks,
              Contains("frame 4: vertical camera: 99 % of its values are black"));
}

TEST_F(SessionFindings, FoldersThatAreNoSession)
{
  EXPECT_THAT(openingFault(folder_.path("none")), HasSubstr("is no folder"));
  EXPECT_THAT(openingFault(folder_.write("file", "a")), HasSubstr("is no folder"));
  EXPECT_THAT(openingFault(folder_.path("")), HasSubstr("rig.yaml"));
  saveTrinocularRig(folder_.path("rig.yaml"), rig_);
  const TrinocularFileGrabber empty(folder_.path(""));
  EXPECT_EQ(empty.frames(), 0U);
  EXPECT_THAT(empty.getReport().remarks, Contains(HasSubstr("has no frame")));
}

TEST_F(SessionFindings, SummariesThatAreMalformed)
{
  recordSession(session_, rig_, 3);
  const std::string path = session_ + "/session.yaml";
  const std::string sound = contentOf(path);
  const auto faultWith = [&](const std::string& old, const std::string& now) {
    std::string text = sound;
    text.replace(text.find(old), old.size(), now);
    std::ofstream(path) << text;
    return openingFault(session_);
  };
  EXPECT_EQ(faultWith("frames: 3", "frames: 3"), "");
  EXPECT_THAT(faultWith("version: 1", "version: 2"), HasSubstr("session.yaml: line 3"));
  EXPECT_THAT(faultWith("frames: 3", "frames: many"), HasSubstr("frames"));
  EXPECT_THAT(faultWith("rig: rig.yaml", "rig: ../rig.yaml"), HasSubstr("rig: must"));
  EXPECT_THAT(faultWith("[reference,", "[left,"), HasSubstr("is no camera"));
  EXPECT_THAT(faultWith("patterns", "pattern"), HasSubstr("session.yaml"));
  std::ofstream(path) << "";
  EXPECT_THAT(openingFault(session_), HasSubstr("session.yaml"));
}

} // namespace
} // namespace pcl::acmap::test
