#include "lit_scenes.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/output_folder.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_writing.h>
#include <pcl/pipeline/session_conversion.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/** Frames in memory, which counts how often each is read. */
class CountedFrames : public FrameReader {
public:
  explicit CountedFrames(const TrinocularRig& rig)
  : rig_(rig)
  {}

  void
  add(const TrinocularFrame& shot)
  {
    shots_.push_back(shot);
    shots_.back().number = shots_.size() - 1;
  }

  void
  breakFrame(std::size_t index)
  {
    broken_.insert(index);
  }

  std::map<std::size_t, int>
  reads() const
  {
    const std::lock_guard lock(mutex_);
    return reads_;
  }

  std::string
  folder() const override
  {
    return {};
  }

  TrinocularRig
  getRig() const override
  {
    return rig_;
  }

  std::size_t
  frames() const override
  {
    return shots_.size();
  }

  std::optional<std::int32_t>
  observationOf(std::size_t index) const override
  {
    return shots_[index].observation;
  }

  TrinocularFrame::Ptr
  frame(std::size_t index) const override
  {
    const std::lock_guard lock(mutex_);
    ++reads_[index];
    if (broken_.count(index) == 0)
      return TrinocularFrame::Ptr(new TrinocularFrame(shots_[index]));
    faults_.broken.push_back(index);
    faults_.remarks.push_back("frame " + std::to_string(index) + " is broken");
    throw InputFileException(faults_.remarks.back());
  }

  FrameFaults
  faults() const override
  {
    const std::lock_guard lock(mutex_);
    return faults_;
  }

private:
  TrinocularRig rig_;
  std::vector<TrinocularFrame> shots_;
  std::set<std::size_t> broken_;
  mutable std::mutex mutex_;
  mutable std::map<std::size_t, int> reads_;
  mutable FrameFaults faults_;
};

/** Two views of an office, numbers 3 and 5, each one shot without and two with a
 * pattern. */
class Sessions : public testing::Test {
protected:
  static constexpr std::size_t shots = 3;

  static void
  SetUpTestSuite()
  {
    SimulatedScene scene = smallScene("office", 64);
    scene.views.resize(2);
    const SimulatedLight light = plainLight();
    SimulatedRigGrabber grabber(
        scene, {wavePattern(light.projector), flatPattern(light.projector, 90)}, light);
    rig_ = scene.rig;
    for (std::size_t view = 0; view < scene.views.size(); ++view)
      for (const auto& frame : grabber.observe(view)) {
        filmed_.push_back(*frame);
        filmed_.back().observation = static_cast<std::int32_t>(3 + 2 * view);
      }
  }

  Sessions()
  {
    for (const TrinocularFrame& frame : filmed_)
      frames_->add(frame);
  }

  std::vector<SessionObservation>
  all(const std::shared_ptr<SessionSource>& session) const
  {
    std::vector<SessionObservation> found;
    while (auto seen = session->next())
      found.push_back(std::move(*seen));
    return found;
  }

  static TrinocularRig rig_;
  static std::vector<TrinocularFrame> filmed_;
  std::shared_ptr<CountedFrames> frames_ = std::make_shared<CountedFrames>(rig_);
};

TrinocularRig Sessions::rig_;
std::vector<TrinocularFrame> Sessions::filmed_;

/** The values of all points. */
std::string
textOf(const PointCloud<PointXYZRGBSigma>& cloud)
{
  std::ostringstream text;
  text << cloud.width << " x " << cloud.height;
  for (const PointXYZRGBSigma& point : cloud)
    text << ' ' << point.x << ' ' << point.y << ' ' << point.z << ' ' << point.rgba
         << ' ' << point.sigma;
  return text.str();
}

TEST_F(Sessions, ReadEachFrameOnce)
{
  const auto session = openSession(frames_);
  EXPECT_EQ(session->size(), 2U);
  EXPECT_TRUE(frames_->reads().empty()) << "read before it is needed";
  const std::vector<SessionObservation> found = all(session);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].number, 3U);
  EXPECT_EQ(found[1].number, 5U);
  EXPECT_EQ(frames_->reads().size(), 2 * shots);
  EXPECT_THAT(frames_->reads(), Each(Pair(testing::_, 1)));
  EXPECT_FALSE(session->next());
  const SessionReport report = session->getReport();
  EXPECT_EQ(report.observations, 2U);
  EXPECT_EQ(report.frames, 2 * shots);
  EXPECT_EQ(report.points, found[0].projection.points + found[1].projection.points);
  EXPECT_GT(report.points, 1000U);
}

TEST_F(Sessions, ObservationsAreTheSameInAnyOrder)
{
  const std::vector<SessionObservation> found = all(openSession(frames_));
  const auto session = openSession(frames_);
  for (const std::size_t i : {1U, 0U, 1U}) {
    const PCLPointCloud2 loaded = session->load(i).cloud;
    PointCloud<PointXYZRGBSigma> cloud;
    fromPCLPointCloud2(loaded, cloud);
    EXPECT_EQ(textOf(cloud), textOf(found[i].cloud)) << i;
    EXPECT_EQ(session->load(i).cloud.data, loaded.data) << i;
  }
  EXPECT_TRUE(session->remarks().empty());
}

TEST_F(Sessions, BecomeAFolderInOneLine)
{
  const TemporaryFolder folder;
  OutputFolder written(folder.path("observations"));
  const ObservationSequence sequence(openSession(frames_));
  writeObservations(written, sequence);
  written.commit();
  const ObservationSequence read(folder.path("observations"));
  EXPECT_THAT(read.names(),
              ElementsAre("observation_0003.pcd", "observation_0005.pcd"));
  EXPECT_EQ(read.names(), sequence.names());
  EXPECT_FALSE(read.hasTrajectory());
  EXPECT_THAT(frames_->reads(), Each(Pair(testing::_, 1)));
  EXPECT_EQ(read.load(1).file->points().size(),
            64U * sequence.load(1).file->cloud.height);
}

std::vector<std::string>
namesIn(const std::string& folder)
{
  return OutputFolder(folder).names();
}

TEST_F(Sessions, AreConvertedWithTheirDisparities)
{
  const TemporaryFolder folder;
  SessionConversion conversion;
  conversion.writes_disparities = true;
  OutputFolder written(folder.path("observations"));
  ConvertedSession converted;
  const auto session = openSession(frames_);
  convertSession(*session, conversion, written, converted);
  written.commit();
  EXPECT_THAT(namesIn(folder.path("observations")),
              ElementsAre("disparity_0003.pfm",
                          "disparity_0003.png",
                          "disparity_0005.pfm",
                          "disparity_0005.png",
                          "observation_0003.pcd",
                          "observation_0005.pcd"));
  EXPECT_EQ(converted.report.points, session->getReport().points);
  EXPECT_EQ(converted.pixels(),
            2 * static_cast<std::size_t>(rig_.width) *
                static_cast<std::size_t>(rig_.height));
  EXPECT_GT(converted.matchedShare(), 0.1);
}

TEST_F(Sessions, ConversionGoesOnWhereItWasInterrupted)
{
  const TemporaryFolder folder;
  const std::string place = folder.path("observations");
  const auto convert = [&](bool stops, ConvertedSession& converted) {
    SessionConversion conversion;
    conversion.goes_on = true;
    conversion.progress = [&](double, const std::string&) {
      return !stops || converted.report.observations == 0;
    };
    OutputFolder written(place);
    convertSession(*openSession(frames_), conversion, written, converted);
  };
  ConvertedSession first;
  EXPECT_THROW(convert(true, first), CancelledException);
  EXPECT_EQ(first.report.observations, 1U);
  EXPECT_THAT(namesIn(place), ElementsAre("finished.json", "observation_0003.pcd"));
  const auto written =
      std::filesystem::last_write_time(place + "/observation_0003.pcd");

  ConvertedSession whole, all_at_once;
  convert(false, whole);
  EXPECT_EQ(std::filesystem::last_write_time(place + "/observation_0003.pcd"), written);
  EXPECT_THAT(namesIn(place),
              ElementsAre("observation_0003.pcd", "observation_0005.pcd"));
  std::filesystem::remove_all(place);
  convert(false, all_at_once);
  EXPECT_EQ(whole.figuresText(), all_at_once.figuresText());
  EXPECT_EQ(whole.report.points, all_at_once.report.points);
}

TEST_F(Sessions, DamagedFiguresOfAnEarlierRunAreNone)
{
  ConvertedSession converted;
  const auto is_there = [](const std::string&) { return true; };
  for (const char* text :
       {"", "{", "7", "[7]", R"([{"file":"observation_0003.pcd","frames":-1}])"}) {
    converted.addFigures(text, is_there);
    EXPECT_EQ(converted.figuresText(), "[]") << text;
    EXPECT_EQ(converted.report.frames, 0U) << text;
  }
}

TEST_F(Sessions, ConversionNeedsAPoseForEachNumber)
{
  const TemporaryFolder folder;
  SessionConversion conversion;
  conversion.poses = folder.path("poses.txt");
  Trajectory poses;
  for (int i = 0; i < 5; ++i) {
    poses.stamps.push_back(i);
    poses.poses.emplace_back(Eigen::Translation3d(i, 0, 0));
  }
  saveTrajectory(conversion.poses, poses);
  OutputFolder written(folder.path("observations"));
  ConvertedSession converted;
  EXPECT_THROW(convertSession(*openSession(frames_), conversion, written, converted),
               InputFileException)
      << "five poses, none for observation 5";
  poses.stamps.push_back(5);
  poses.poses.emplace_back(Eigen::Translation3d(5, 0, 0));
  saveTrajectory(conversion.poses, poses);
  convertSession(*openSession(frames_), conversion, written, converted);
  written.commit();
  EXPECT_EQ(ObservationSequence(folder.path("observations"))
                .load(1)
                .T_map_camera.translation()
                .x(),
            5);
}

TEST_F(Sessions, LeaveOutBrokenFrames)
{
  frames_->breakFrame(1);
  const auto session = openSession(frames_);
  const std::vector<SessionObservation> found = all(session);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].frames, shots - 1);
  EXPECT_EQ(found[1].frames, shots);
  EXPECT_THAT(session->remarks(), ElementsAre("frame 1 is broken"));

  SessionSettings strict;
  strict.skip_broken = false;
  EXPECT_THROW(openSession(frames_, strict)->load(0), InputFileException);
}

TEST_F(Sessions, NumbersStayThoughAnObservationIsBroken)
{
  for (std::size_t i = 0; i < shots; ++i)
    frames_->breakFrame(i);
  const auto session = openSession(frames_);
  EXPECT_EQ(session->size(), 2U);
  EXPECT_THROW(session->load(0), InputFileException);
  EXPECT_EQ(session->nameOf(1), "observation_0005.pcd");
  const std::vector<SessionObservation> found = all(session);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].number, 5U);
}

TEST_F(Sessions, FramesOfAnotherObservationEndOne)
{
  frames_->add(filmed_.front());
  const auto session = openSession(frames_);
  const std::vector<SessionObservation> found = all(session);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].frames, shots);
  EXPECT_THAT(session->remarks(),
              ElementsAre("observation 3: its frames from 6 on are left out, frames of "
                          "another one stand before them"));
  EXPECT_EQ(frames_->reads().size(), 2 * shots + 1);
}

TEST_F(Sessions, OnlyShotsWithoutAPatternIfTheseAreWanted)
{
  SessionSettings unlit;
  unlit.unlit = true;
  const std::vector<SessionObservation> found = all(openSession(frames_, unlit));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].frames, 1U);
  EXPECT_TRUE(found[0].fusion.is_passive);
}

TEST_F(Sessions, WhatCannotBeSearchedIsRefused)
{
  EXPECT_THROW(openSession(nullptr), BadArgumentException);
  SessionSettings settings;
  settings.projection.setMinimumDepth(10);
  EXPECT_THROW(openSession(frames_, settings), BadArgumentException);
  settings.projection.setMinimumDepth(0.01);
  settings.projection.setMaximumDepth(0.02);
  EXPECT_THROW(openSession(frames_, settings), BadArgumentException);
}

TEST_F(Sessions, MemoryIsAskedForBefore)
{
  const CostCallback refuse = [](const std::string& work, std::size_t bytes, double) {
    EXPECT_THAT(work, HasSubstr("disparities"));
    EXPECT_GT(bytes, 0U);
    throw std::runtime_error("too much");
  };
  EXPECT_THROW(openSession(frames_, {}, refuse), std::runtime_error);
  EXPECT_TRUE(frames_->reads().empty());
}

} // namespace
} // namespace pcl::acmap::test
