#include "digiclops_runs.h"
#include "json_file.h"
#include "simulated_runs.h"
#include "temporary_folder.h"
#include "video_writer.h"
#include "virtual_display.h"
#include "webcam_pair.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/simulation/scene_file.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* corner = R"(name: corner
rig: {width: 320, height: 240, focal_length: 260, center_x: 159.5, center_y: 119.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 6, points: 1500}
looks:
  wall: {color: [170, 168, 162], texture: 2}
  floor: {color: [128, 122, 114], texture: 4}
surfaces:
  - rectangle: {name: floor, corner: [-3, 0.8, -1], edges: [[6, 0, 0], [0, 0, 5]], look: floor}
  - rectangle: {name: left wall, corner: [-1.2, 0.8, -1], edges: [[0, 0, 5], [0, -3, 0]], look: wall}
  - rectangle: {name: far wall, corner: [-3, 0.8, 2.6], edges: [[6, 0, 0], [0, -3, 0]], look: wall}
path:
  - line: {from: [0, 0, 0], to: [0, 0, 0.1], views: 2, yaw: [-12, -8]}
)";

constexpr int patterns = 4;

ToolRun
runCameras(const std::vector<std::string>& arguments, const RunSettings& settings = {})
{
  return runTool(ACMAP_CAMERA_GRABBER, arguments, settings);
}

/** \brief Two simulated webcams that look at a corner of a room, and a projector on a
 * virtual screen. */
class CameraPair : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    folders_ = new TemporaryFolder;
    display_ = new VirtualDisplay("512x384x24");
    if (!display_->exists() || !canPipe())
      return;
    RandomLinePattern lines;
    lines.setSize(512, 384);
    for (std::uint32_t i = 0; i < patterns; ++i)
      lights_.push_back(lines.generate(i));
    RgbImage white = lights_.front();
    white.values.assign(white.values.size(), 255);
    lights_.push_back(white);
    film_ = new FilmedByCamera(
        loadSimulatedScene(folders_->write("corner.yaml", corner)), lights_);
    recordPair(*film_, truth());
    runTool(ACMAP_ACTIVE_STEREO, {truth(), "-o", trueClouds()}).succeeded();
  }

  static void
  TearDownTestSuite()
  {
    delete film_;
    film_ = nullptr;
    delete display_;
    delete folders_;
    lights_.clear();
  }

  void
  SetUp() override
  {
    if (!film_)
      GTEST_SKIP() << "no X server for the projector, or GStreamer lacks plugins "
                      "(gstreamer1.0-plugins-base)";
    projector_.emplace(lights_);
    film_->watch(*projector_);
    cameras_.emplace(*film_);
  }

  ToolRun
  grab(const std::vector<std::string>& more = {}, const RunSettings& settings = {})
  {
    return runCameras(joined({"--device",
                              cameras_->devices()[0],
                              cameras_->devices()[1],
                              "--rig",
                              truth() + "/rig.yaml",
                              "--pcd",
                              clouds_,
                              "-o",
                              recorded_,
                              "--patterns",
                              std::to_string(patterns)},
                             more),
                      settings);
  }

  static std::string
  truth()
  {
    return folders_->path("truth");
  }

  static std::string
  trueClouds()
  {
    return folders_->path("clouds");
  }

  static TemporaryFolder* folders_;
  static VirtualDisplay* display_;
  static std::vector<RgbImage> lights_;
  static FilmedByCamera* film_;

  TemporaryFolder folder_;
  std::string clouds_ = folder_.path("clouds");
  std::string recorded_ = folder_.path("recorded");
  std::optional<ProjectorWatch> projector_;
  std::optional<WebcamPair> cameras_;
};

TemporaryFolder* CameraPair::folders_ = nullptr;
VirtualDisplay* CameraPair::display_ = nullptr;
std::vector<RgbImage> CameraPair::lights_;
FilmedByCamera* CameraPair::film_ = nullptr;

TEST_F(CameraPair, ObservationsAreTheSimulatorsOwn)
{
  const std::string report = folder_.path("report.json");
  const ToolRun run = grab({"--observations", "2", "--report", report}).succeeded();
  expectSameFiles(clouds_, trueClouds());
  const auto frames = framesOf(recorded_);
  const auto own = framesOf(truth());
  ASSERT_EQ(frames.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(frames[i]->observation, own[i]->observation);
    EXPECT_EQ(frames[i]->pattern, own[i]->pattern);
    EXPECT_TRUE(frames[i]->images == own[i]->images) << i;
  }
  EXPECT_THAT(run.err, HasSubstr("its exposure cannot be fixed")); // of a pipeline
  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["cameras"].size(), 2u);
  EXPECT_EQ(json["cameras"][0]["rate"], 30);
  EXPECT_EQ(json["frames"], 2 * (patterns + 1));
  EXPECT_EQ(json["observations"].size(), 2u);
}

TEST_F(CameraPair, TimeToSettleIsMeasured)
{
  projector_->setDelay(
      std::chrono::milliseconds(300)); // six images; five are discarded
  const std::string report = folder_.path("report.json");
  const ToolRun run = grab({"--settle", "auto", "--report", report}).succeeded();
  EXPECT_THAT(run.err, HasSubstr("the projector settles in "));
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(CameraPair, AnUnpluggedCameraLeavesTheObservationsBefore)
{
  // The warm-up, and seven images of each shot: in the second observation.
  cameras_->unplugAt(10 + 7 * (patterns + 1) + 7 * 2);
  const ToolRun run = grab({"--observations", "2"});
  expectFails(run, 1, "observations finished by then, in " + clouds_ + ": 1;");
  EXPECT_THAT(run.err, HasSubstr("gives no more images; was it unplugged?"));
  EXPECT_THAT(run.err, HasSubstr("frames recorded by then, in " + recorded_ + ": 5\n"));
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(CameraPair, ASceneThatMovesIsTold)
{
  cameras_->moveFrom(30);
  expectFails(grab(), 1, "the scene moves: two successive images of the ");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(CameraPair, MakesAMap)
{
  const std::string map = folder_.path("map");
  runCameras({"--device",
              cameras_->devices()[0],
              cameras_->devices()[1],
              "--rig",
              truth() + "/rig.yaml",
              "--map",
              map,
              "--patterns",
              std::to_string(patterns)})
      .succeeded();
  const auto planes = jsonOfFile(map + "/map.json")["planes"];
  EXPECT_EQ(planes.size(), 3u);
}

TEST_F(CameraPair, WithoutAProjectorStillFramesAreStreamed)
{
  runCameras({"--device",
              cameras_->devices()[0],
              cameras_->devices()[1],
              "--rig",
              truth() + "/rig.yaml",
              "-o",
              recorded_,
              "--patterns",
              "0",
              "--rate",
              "10",
              "--frames",
              "6"})
      .succeeded();
  EXPECT_EQ(framesOf(recorded_).size(), 6u);
  EXPECT_TRUE(framesOf(recorded_)[5]->images == framesOf(truth())[0]->images);
}

/** \brief Two videos that were filmed before. */
class CameraVideos : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    folders_ = new TemporaryFolder;
    pair_ = new FilmedPair(filmPair());
    videos_ = writeVideos(*pair_, folders_->path(""), ".mkv");
    saveTrinocularRig(rig(), pair_->rig);
  }

  static void
  TearDownTestSuite()
  {
    delete pair_;
    delete folders_;
  }

  static std::string
  rig()
  {
    return folders_->path("rig.yaml");
  }

  /** \brief Streams the videos into a session. */
  ToolRun
  stream(const std::vector<std::string>& devices,
         const std::string& rig,
         const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> all = joined({"--device"}, devices);
    all.insert(all.end(), {"--rig", rig, "--patterns", "0", "-o", recorded_});
    all.insert(all.end(), more.begin(), more.end());
    return runCameras(all);
  }

  static TemporaryFolder* folders_;
  static FilmedPair* pair_;
  static std::vector<std::string> videos_;

  TemporaryFolder folder_;
  std::string recorded_ = folder_.path("recorded");
};

TemporaryFolder* CameraVideos::folders_ = nullptr;
FilmedPair* CameraVideos::pair_ = nullptr;
std::vector<std::string> CameraVideos::videos_;

TEST_F(CameraVideos, AreRecordedWhereTheSceneStandsStill)
{
  const ToolRun run = stream(videos_, rig()).succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("30 images/s, a recording"));
  // 10 for the warm-up, one to compare, and for three changes of the light two each
  const auto frames = framesOf(recorded_);
  ASSERT_EQ(frames.size(), 10u + 7 * 4 - 10 - 1 - 2 * 3);
  EXPECT_TRUE(frames.back()->images == pair_->shots[3]->images);
  const std::string again = folder_.path("again");
  EXPECT_EQ(runCameras({"--device", recorded_, "-o", again}).exit_code, 0);
  EXPECT_EQ(framesOf(again).size(), frames.size());
  fs::rename(recorded_, folder_.path("first"));
  ASSERT_EQ(stream(videos_, rig()).exit_code, 0);
  expectSameFiles(recorded_, folder_.path("first")); // the same bytes each time
}

TEST_F(CameraVideos, WhatCannotWorkIsRefused)
{
  const std::string left = videos_[0];
  const std::string right = videos_[1];
  fs::copy(left, folders_->path("copy.mkv"));
  expectFails(stream({left, left}, rig()), 2, "they are one camera");
  expectFails(stream({left, folders_->path("copy.mkv")}, rig()), 2, "the same image");
  expectFails(stream({left}, rig()), 2, "1 cameras are refused: the rig has 2");
  expectFails(stream({left, right, right}, rig()), 2, "3 cameras are refused");
  expectFails(stream({left, folders_->path("none.mkv")}, rig()), 4, "no such camera");
  expectFails(stream({left, "4711"}, rig()), 4, "/dev/video4711: there is no such");
  expectFails(stream({left, rig()}, rig()), 3, "rig.yaml: is no video");
  expectFails(stream({left, "nosuchsrc ! appsink"}, rig()), 1, "this pipeline");
  expectFails(stream({left, "/dev/null"}, rig()), 1, "/dev/null: cannot be opened");
  expectFails(stream({left, folder_.path("")}, rig()), 3, "is a folder");
  expectFails(stream({left, right}, folders_->path("none.yaml")), 3, "none.yaml");
  TrinocularRig small = pair_->rig;
  small.width /= 2;
  saveTrinocularRig(folders_->path("small.yaml"), small);
  expectFails(stream({left, right}, folders_->path("small.yaml")),
              1,
              "gives images of 640 x 480 pixels, the rig has 320 x 480 pixels");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(CameraVideos, OptionsWithoutSenseAreRefused)
{
  expectFails(runCameras({"--rig", rig(), "-o", recorded_}), 2, "--device is needed");
  expectFails(runCameras({"--device", videos_[0], videos_[1], "-o", recorded_}),
              2,
              "--rig is needed");
  expectFails(runCameras({"--device", videos_[0], videos_[1], "--rig", rig()}),
              2,
              "nothing to do");
  expectFails(stream(videos_, rig(), {"--max-change", "0"}), 2, "--max-change");
  expectFails(stream(videos_, rig(), {"--warm-up", "-1"}), 2, "--warm-up");
  expectFails(stream(videos_, rig(), {"--format", "MJPEG"}), 2, "MJPEG");
  expectFails(stream(videos_, rig(), {"--gain", "auto"}), 2, "--gain auto");
  expectFails(stream(videos_, rig(), {"--shutter", "0.01"}), 1, "refuses exposure");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(CameraVideos, CamerasOfTheSystemAreListed)
{
  const ToolRun run = runCameras({"--list"});
  if (fs::exists("/sys/class/video4linux") && !fs::is_empty("/sys/class/video4linux"))
    EXPECT_EQ(run.exit_code, 0) << run.err;
  else
    expectFails(run, 4, "the system has no camera");
}

} // namespace
} // namespace pcl::acmap::test
