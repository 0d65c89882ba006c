#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_recorder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class SessionRecorder : public testing::Test {
protected:
  std::string
  refusal(TrinocularRecorder& recorder, const TrinocularFrame& frame) const
  {
    return faultOfRunning<BadArgumentException>([&] { recorder.record(frame); });
  }

  std::string
  beginning(const std::string& folder) const
  {
    return faultOfRunning<OutputFileException>(
        [&] { TrinocularRecorder recorder(folder, rig_); });
  }

  TemporaryFolder folder_;
  std::string session_ = folder_.path("session");
  TrinocularRig rig_ = rigOf(32, 24);
};

TEST_F(SessionRecorder, WhatItWritesIsReadBackEqual)
{
  recordSession(session_, rig_, 7);
  const TrinocularFileGrabber grabber(session_);
  ASSERT_EQ(grabber.frames(), 7U);
  for (std::uint64_t i = 0; i < 7; ++i)
    expectEqual(*grabber.frame(i), recordedFrame(rig_, i));
  EXPECT_EQ(grabber.getRig().width, rig_.width);
  EXPECT_EQ(grabber.getRig().baseline_vertical, rig_.baseline_vertical);
  EXPECT_EQ(contentOf(session_ + "/session.yaml"),
            "%YAML:1.0\n---\nversion: 1\nrig: rig.yaml\nframes: 7\nobservations: 3\n"
            "patterns: 2\ncameras: [reference, horizontal, vertical]\n");
}

TEST_F(SessionRecorder, EachFrameIsThereAtOnce)
{
  TrinocularRecorder recorder(session_, rig_);
  for (std::uint64_t i = 0; i < 3; ++i) {
    recorder.record(recordedFrame(rig_, i));
    EXPECT_EQ(TrinocularFileGrabber(session_).frames(), i + 1);
    EXPECT_EQ(recorder.frames(), i + 1);
  }
  EXPECT_FALSE(TrinocularFileGrabber(session_).getReport().is_finished);
  recorder.finish();
  recorder.finish();
  EXPECT_TRUE(TrinocularFileGrabber(session_).getReport().is_finished);
  EXPECT_THAT(refusal(recorder, recordedFrame(rig_, 3)),
              HasSubstr("frame 3: the session is finished"));
}

TEST_F(SessionRecorder, DiscardsASessionWithoutFrames)
{
  {
    TrinocularRecorder recorder(session_, rig_);
    recorder.finish();
    recorder.discardIfEmpty();
  }
  EXPECT_FALSE(fs::exists(session_));
  fs::create_directory(session_);
  TrinocularRecorder recorder(session_, rig_);
  recorder.discardIfEmpty();
  EXPECT_TRUE(fs::is_empty(session_)) << "the folder was there before";

  TrinocularRecorder again(session_, rig_);
  again.record(recordedFrame(rig_, 0));
  again.discardIfEmpty();
  again.record(recordedFrame(rig_, 1));
  again.finish();
  EXPECT_EQ(TrinocularFileGrabber(session_).frames(), 2U);
}

TEST_F(SessionRecorder, OverwritesNoSession)
{
  recordSession(session_, rig_, 1);
  const std::string begun = folder_.path("begun");
  {
    const TrinocularRecorder recorder(begun, rig_);
  }
  const std::string frames = folder_.path("frames");
  fs::create_directory(frames);
  fs::copy(session_ + "/frame_000000.acf", frames);
  for (const std::string& folder : {session_, begun, frames})
    EXPECT_THAT(beginning(folder), HasSubstr(folder + ": holds a session already"));
  EXPECT_EQ(TrinocularFileGrabber(session_).frames(), 1U);
  EXPECT_THAT(beginning(folder_.path("no/session")), HasSubstr("No such file"));
  EXPECT_NE(beginning(folder_.write("file", "a")), "");
  const std::string other = folder_.path("other");
  fs::create_directory(other);
  std::ofstream(other + "/notes.txt") << "a";
  EXPECT_EQ(beginning(other), "");
}

TEST_F(SessionRecorder, RefusesARigThatCannotBe)
{
  rig_.width = 0;
  EXPECT_THROW(TrinocularRecorder(session_, rig_), BadArgumentException);
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(SessionRecorder, RefusesFramesByTheirNumber)
{
  TrinocularRecorder recorder(session_, rig_);
  recorder.record(frameOf(rig_, 4, 1, 2));
  EXPECT_THAT(refusal(recorder, frameOf(rig_, 4, 1, 3)),
              HasSubstr("frame 4: a frame of this number was recorded before"));
  EXPECT_THAT(refusal(recorder, frameOf(rig_, 5, 1, 2)),
              HasSubstr("frame 5: observation 1 under pattern 2 was recorded before"));
  EXPECT_THAT(refusal(recorder, frameOf(rigOf(32, 20), 6, 0, 0)),
              HasSubstr("frame 6: reference camera: 32 x 20 pixels, the rig has 32 x"));
  TrinocularFrame frame = frameOf(rig_, 7, 0, 0);
  frame.image(RigCamera::Vertical) = {};
  EXPECT_THAT(refusal(recorder, frame),
              HasSubstr("frame 7: vertical camera: has no image"));
  frame.image(RigCamera::Vertical) = noisyImage(24, 32, 1, 1);
  EXPECT_THAT(refusal(recorder, frame), HasSubstr("frame 7: vertical camera: 24 x 32"));
  frame.image(RigCamera::Vertical) = noisyImage(32, 24, 1, 1);
  frame.image(RigCamera::Horizontal).values.resize(7);
  EXPECT_THAT(refusal(recorder, frame),
              HasSubstr("frame 7: horizontal camera: 7 byte"));
  EXPECT_EQ(recorder.frames(), 1U);
  EXPECT_EQ(TrinocularFileGrabber(session_).frames(), 1U);
  // Rejected frames have no effect: number and shot are still free.
  recorder.record(frameOf(rig_, 7, 0, 0));
}

TEST_F(SessionRecorder, KnowsRigsOfTwoCameras)
{
  rig_.baseline_vertical = 0;
  TrinocularRecorder recorder(session_, rig_);
  TrinocularFrame frame = frameOf(rig_, 0, 0, 0);
  frame.image(RigCamera::Vertical) = frame.image(RigCamera::Reference);
  EXPECT_THAT(refusal(recorder, frame), HasSubstr("the rig has no such camera"));
  frame.image(RigCamera::Vertical) = {};
  recorder.record(frame);
  recorder.finish();
  EXPECT_THAT(contentOf(session_ + "/session.yaml"),
              HasSubstr("cameras: [reference, horizontal]"));
  expectEqual(*TrinocularFileGrabber(session_).frame(0), frame);
}

RigCalibration
distortedCamerasOf(const TrinocularRig& rig)
{
  RigCalibration calibration = calibrationOf(rig);
  for (CameraCalibration& camera : calibration.cameras)
    camera.distortion = {-0.25, 0.08, 5e-4, -4e-4, 0};
  calibration.camera(RigCamera::Horizontal)
      .T_reference_camera.rotate(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY()));
  return calibration;
}

TEST_F(SessionRecorder, KeepsTheCamerasAsTheyAreBuilt)
{
  rig_.baseline_vertical = 0;
  const RigCalibration calibration = distortedCamerasOf(rig_);
  TrinocularRecorder recorder(session_, rig_, calibration);
  EXPECT_THAT(refusal(recorder, frameOf(rigOf(32, 20), 0, 0, 0)),
              HasSubstr("frame 0: reference camera: 32 x 20 pixels, the rig has 32 x"));
  recorder.record(frameOf(rig_, 0, 0, 0));
  recorder.finish();
  const TrinocularFileGrabber grabber(session_);
  EXPECT_THAT(grabber.getReport().remarks, testing::IsEmpty());
  expectEqual(*grabber.frame(0), frameOf(rig_, 0, 0, 0));
  EXPECT_EQ(grabber.getRig().baseline_horizontal, rig_.baseline_horizontal);
  const RigCalibration read = loadRigCalibration(session_ + "/rig.yaml");
  EXPECT_EQ(read.width, 32);
  EXPECT_FALSE(read.camera(RigCamera::Vertical).is_there);
  for (const RigCamera camera : {RigCamera::Reference, RigCamera::Horizontal}) {
    const CameraCalibration& built = calibration.camera(camera);
    EXPECT_EQ(read.camera(camera).distortion, built.distortion);
    EXPECT_EQ(read.camera(camera).T_reference_camera.matrix(),
              built.T_reference_camera.matrix());
  }
}

TEST_F(SessionRecorder, RefusesCamerasThatAreNotOfTheRig)
{
  const auto expectRefused = [&](const RigCalibration& calibration) {
    EXPECT_THROW(TrinocularRecorder(session_, rig_, calibration), BadArgumentException);
    EXPECT_EQ(folder_.count(), 0) << "a folder stays behind";
  };
  expectRefused(distortedCamerasOf(rigOf(32, 20)));
  RigCalibration calibration = distortedCamerasOf(rig_);
  calibration.camera(RigCamera::Vertical).is_there = false;
  expectRefused(calibration);
  calibration = distortedCamerasOf(rig_);
  calibration.cameras[1].focal_x = 0;
  expectRefused(calibration);
  fs::create_directory(session_); // an existing folder is kept
  EXPECT_THROW(TrinocularRecorder(session_, rig_, calibration), BadArgumentException);
  EXPECT_TRUE(fs::is_empty(session_));
}

TEST_F(SessionRecorder, AFullDiskLosesNoMoreThanTheFrame)
{
  TrinocularRecorder recorder(session_, rig_);
  recorder.record(recordedFrame(rig_, 0));
  fs::create_symlink("/dev/full", session_ + "/frame_000001.acf");
  EXPECT_THAT(faultOfRunning<OutputFileException>(
                  [&] { recorder.record(recordedFrame(rig_, 1)); }),
              HasSubstr("frame_000001.acf: No space left"));
  EXPECT_EQ(recorder.frames(), 1U);
  fs::remove(session_ + "/frame_000001.acf");
  recorder.record(recordedFrame(rig_, 1));
  fs::create_symlink("/dev/full", session_ + "/session.yaml");
  EXPECT_THROW(recorder.finish(), OutputFileException);
  fs::remove(session_ + "/session.yaml");
  recorder.finish();
  const TrinocularFileGrabber grabber(session_);
  EXPECT_TRUE(grabber.getReport().is_finished);
  EXPECT_EQ(grabber.frames(), 2U);
}

/** Records until it is killed; reports each frame after it is recorded. */
[[noreturn]] void
recordUntilKilled(const std::string& session, const TrinocularRig& rig, int told)
{
  TrinocularRecorder recorder(session, rig);
  for (std::uint64_t number = 0;; ++number) {
    recorder.record(recordedFrame(rig, number));
    if (::write(told, "f", 1) != 1)
      ::_exit(1);
  }
}

TEST_F(SessionRecorder, AKilledRunLosesAtMostOneFrame)
{
  for (const std::uint64_t frames : {1U, 4U, 9U}) {
    const std::string session = folder_.path("killed" + std::to_string(frames));
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0)
      recordUntilKilled(session, rigOf(160, 120), ends[1]);
    ::close(ends[1]);
    std::uint64_t told = 0;
    char sign = 0;
    while (told < frames && ::read(ends[0], &sign, 1) == 1)
      ++told;
    ::kill(child, SIGKILL);
    while (::read(ends[0], &sign, 1) == 1)
      ++told;
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    ASSERT_GE(told, frames);

    const TrinocularFileGrabber grabber(session);
    EXPECT_FALSE(grabber.getReport().is_finished);
    EXPECT_TRUE(grabber.getReport().broken.empty());
    EXPECT_GE(grabber.frames(), told);
    EXPECT_LE(grabber.frames(), told + 1);
    for (std::size_t i = 0; i < grabber.frames(); ++i)
      expectEqual(*grabber.frame(i), recordedFrame(rigOf(160, 120), i));
  }
}

} // namespace
} // namespace pcl::acmap::test
