#include "active_stereo_runs.h"
#include "json_file.h"
#include "simulated_runs.h"
#include "unfinished_file.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_writing.h>
#include <pcl/pipeline/session_source.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::Not;

using ActiveStereoSession = ActiveStereoRuns;

/** \brief Copies a session without some of its frames. */
std::string
copiedWithout(const std::string& session,
              const TemporaryFolder& folder,
              const std::vector<std::string>& frames)
{
  const std::string copy = folder.path("copy");
  std::filesystem::copy(session, copy);
  for (const std::string& name : frames)
    EXPECT_TRUE(std::filesystem::remove(copy + "/" + name)) << name;
  return copy;
}

TEST_F(ActiveStereoSession, ObservationsLieOnTheTruth)
{
  const ToolRun run = runSession().succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("observations: 2\n"));
  EXPECT_THAT(run.out, HasSubstr("14, taken as rectified"));
  EXPECT_THAT(run.out, HasSubstr("depths of 0.5 to 10 m"));
  const TrinocularRig rig = loadTrinocularRig(rig_);
  for (const int observation : {0, 1}) {
    const StereoFile file =
        loadStereo(out("observation_000" + std::to_string(observation) + ".pcd"));
    ASSERT_EQ(file.cloud.width, 160u);
    ASSERT_EQ(file.cloud.height, 120u);
    const TruthFit fit = fitOf(disparityOf(file.cloud, rig), session(), observation);
    EXPECT_GT(fit.found, 0.85);
    EXPECT_LT(fit.wrong, 0.02);
    EXPECT_LT(fit.median, 0.1);
    EXPECT_TRUE(file.orientation.isApprox(Eigen::Quaternionf::Identity()));
    EXPECT_TRUE(file.origin.head<3>().isZero());
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out_), {}), 2);
}

/** A program gets the observations that the tool writes. */
TEST_F(ActiveStereoSession, TheClassWritesTheSameBytes)
{
  runSession().succeeded();
  OutputFolder written(folder_.path("written"));
  writeObservations(written,
                    ObservationSequence(openSession(
                        std::make_shared<TrinocularFileGrabber>(session()))));
  written.commit();
  for (const char* const name : {"observation_0000.pcd", "observation_0001.pcd"})
    EXPECT_EQ(contentOf(folder_.path("written") + "/" + name), contentOf(out(name)))
        << name;
}

TEST_F(ActiveStereoSession, PointsAreInTheCameraFrameWithColourEverywhere)
{
  runSession().succeeded();
  const TrinocularRig rig = loadTrinocularRig(rig_);
  const auto frames = framesOf(session());
  ASSERT_EQ(frames[0]->pattern, TrinocularFrame::no_pattern);
  const CameraImage& off = frames[0]->images[0];
  const StereoCloud cloud = loadStereo(out("observation_0000.pcd")).cloud;
  std::size_t empty = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const PointXYZRGBSigma& point = cloud[i];
    const auto column = static_cast<double>(i % cloud.width);
    const auto row = static_cast<double>(i / cloud.width);
    ASSERT_EQ(point.r, off.values[3 * i]) << i;
    ASSERT_EQ(point.g, off.values[3 * i + 1]) << i;
    ASSERT_EQ(point.b, off.values[3 * i + 2]) << i;
    if (std::isfinite(point.z)) {
      ASSERT_NEAR(point.x, (column - rig.center_x) * point.z / rig.focal_length, 1e-5);
      ASSERT_NEAR(point.y, (row - rig.center_y) * point.z / rig.focal_length, 1e-5);
      ASSERT_GT(point.sigma, 0.0f);
    }
    else {
      ++empty;
      ASSERT_TRUE(std::isnan(point.x) && std::isnan(point.y) &&
                  std::isnan(point.sigma));
    }
  }
  EXPECT_GT(empty, 0u);
}

TEST_F(ActiveStereoSession, KnownPosesAreTakenByNumberWhereTheyAreNamed)
{
  // the first observation is missing: the second keeps its number and its pose
  std::vector<std::string> first;
  for (int i = 0; i < 7; ++i)
    first.push_back("frame_00000" + std::to_string(i) + ".acf");
  input_ = copiedWithout(session(), folder_, first);
  const std::string poses = session() + "/trajectory.txt";
  runSession({"--poses", poses}).succeeded();
  EXPECT_FALSE(std::filesystem::exists(out("observation_0000.pcd")));
  EXPECT_EQ(contentOf(out("trajectory.txt")), contentOf(poses));
  const Eigen::Isometry3f pose = loadTrajectory(poses).poses[1].cast<float>();
  const StereoFile file = loadStereo(out("observation_0001.pcd"));
  EXPECT_TRUE(file.origin.head<3>().isApprox(pose.translation(), 1e-5f));
  EXPECT_TRUE(file.orientation.toRotationMatrix().isApprox(pose.linear(), 1e-5f));
}

TEST_F(ActiveStereoSession, PosesOfOtherObservationsAreRefused)
{
  Trajectory one = loadTrajectory(session() + "/trajectory.txt");
  one.poses.resize(1);
  one.stamps.resize(1);
  saveTrajectory(folder_.path("one.txt"), one);
  expectRefused(runSession({"--poses", folder_.path("one.txt")}), 3, "observation 1");
  expectRefused(runSession({"--poses", folder_.path("none.txt")}), 3, "none.txt");
}

TEST_F(ActiveStereoSession, NamesMayHaveSpacesAndAnyLetters)
{
  const std::string poses = session() + "/trajectory.txt";
  runSession({"--poses", poses}).succeeded();
  const std::string plain = contentOf(out("observation_0001.pcd"));
  input_ = folder_.path("a ö");
  std::filesystem::copy(session(), input_);
  out_ = folder_.path("ö ut");
  const std::string report = folder_.path("é r.json");
  const ToolRun run =
      runSession({"--poses", input_ + "/trajectory.txt", "--report", report})
          .succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(contentOf(out("observation_0001.pcd")), plain);
  EXPECT_EQ(contentOf(out("trajectory.txt")), contentOf(poses));
  EXPECT_EQ(jsonOfFile(report)["observations"].size(), 2u);
}

TEST_F(ActiveStereoSession, DisparitiesAreWrittenOnRequest)
{
  runSession({"--disparity"}).succeeded();
  const DisparityImage disparity = loadPfm(out("disparity_0001.pfm"));
  const GrayImage16 picture = loadGrayImage16(out("disparity_0001.png"));
  const StereoCloud cloud = loadStereo(out("observation_0001.pcd")).cloud;
  const DisparityImage meant = disparityOf(cloud, loadTrinocularRig(rig_));
  ASSERT_EQ(picture.width, 160);
  float brightest = 0;
  std::size_t found = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float value = disparity.values[i];
    ASSERT_EQ(picture.values[i] == 0, std::isnan(value)) << i;
    if (std::isnan(value))
      continue;
    ++found;
    ASSERT_GE(picture.values[i], 64);
    if (picture.values[i] == 255)
      brightest = std::max(brightest, value);
    if (std::isfinite(meant.values[i])) {
      ASSERT_NEAR(meant.values[i], value, 1e-3);
    }
  }
  ASSERT_GT(found, 1000u);
  // pixels that are not the brightest are not nearer
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (picture.values[i] < 255 && std::isfinite(disparity.values[i])) {
      ASSERT_LE(disparity.values[i], brightest);
    }
}

TEST_F(ActiveStereoSession, ShotsWithoutProjectedLightAreMatchedOnRequest)
{
  const std::string path = folder_.path("report.json");
  const ToolRun run =
      runSession({"--unlit", "--disparity", "--report", path}).succeeded();
  EXPECT_THAT(run.out, HasSubstr(" 2, taken as rectified"));
  EXPECT_THAT(run.out, HasSubstr("passive stereo, shots without projected light"));
  const auto report = jsonOfFile(path);
  EXPECT_EQ(report["method"], "passive");
  EXPECT_EQ(report["observations"][0]["shots"], 0);
  EXPECT_EQ(report["observations"][0]["off_shots"], 1);
  const DisparityImage passive = loadPfm(out("disparity_0000.pfm"));

  // the same shot as a pair of lists
  const TrinocularFrame::ConstPtr off = framesOf(session())[0];
  ASSERT_EQ(off->pattern, TrinocularFrame::no_pattern);
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const CameraImage& image = off->images[i];
    images_[i] = {folder_.path("off" + std::to_string(i) + ".png")};
    savePng(images_[i][0], RgbImage{image.width, image.height, image.values});
  }
  std::filesystem::remove_all(out_);
  runLists().succeeded();
  const DisparityImage pair = loadPfm(out("disparity.pfm"));
  ASSERT_EQ(passive.values.size(), pair.values.size());
  EXPECT_EQ(std::memcmp(passive.values.data(),
                        pair.values.data(),
                        pair.values.size() * sizeof(float)),
            0);
}

TEST_F(ActiveStereoSession, WithoutAnUnlitShotThereIsNothingToMatchPassively)
{
  input_ = copiedWithout(session(), folder_, {"frame_000000.acf", "frame_000007.acf"});
  expectRefused(runSession({"--unlit"}), 3, "no shot without projected light");
  input_ = session();
  expectRefused(runSession({"--unlit", "--method", "median"}), 2, "--unlit");
  expectRefused(runLists({"--unlit"}), 2, "--unlit");
}

TEST_F(ActiveStereoSession, RawFramesAreRectified)
{
  const std::string raw = folder_.path("raw");
  runTool(ACMAP_SIMULATED_RIG,
          {"-o",
           raw,
           "--scene",
           filmed_->path("room.yaml"),
           "--patterns",
           "5",
           "--observations",
           "1",
           "--cameras",
           ACMAP_SHARE "/rigs/digiclops_built.yaml"})
      .succeeded();
  input_ = raw;
  const ToolRun run = runSession({"--min-depth", "1"}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("6, rectified here"));
  const StereoCloud cloud = loadStereo(out("observation_0000.pcd")).cloud;
  const TruthFit fit =
      fitOf(disparityOf(cloud, loadTrinocularRig(raw + "/rig.yaml")), raw);
  EXPECT_GT(fit.found, 0.8);
  EXPECT_LT(fit.wrong, 0.03);
  EXPECT_LT(fit.median, 0.3);

  // the same images as lists, for which the option is required
  images_ = writeImages(raw, folder_);
  rig_ = raw + "/rig.yaml";
  const std::string first = contentOf(out("observation_0000.pcd"));
  std::filesystem::remove_all(out_);
  const ToolRun lists =
      runLists({"--rectify", "--min-depth", "1", "--color", folder_.path("off.png")})
          .succeeded();
  EXPECT_EQ(lists.err, "");
  EXPECT_EQ(contentOf(out("observation_0000.pcd")), first);
  std::filesystem::remove_all(out_);
  EXPECT_THAT(runLists({"--min-depth", "1"}).err, HasSubstr("--rectify"));
}

TEST_F(ActiveStereoSession, ReportTellsOfEachObservation)
{
  const std::string report = folder_.path("report.json");
  const ToolRun run = runSession({"--report", report, "--quiet"}).succeeded();
  EXPECT_EQ(run.out + run.err, "");
  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["frames"], "rectified");
  EXPECT_EQ(json["method"], "spacetime");
  EXPECT_EQ(json["least_disparity"], 0);
  EXPECT_EQ(json["most_disparity"], 27); // 130 px * 0.1 m / 0.5 m, plus one pixel
  EXPECT_EQ(json["has_poses"], false);
  ASSERT_EQ(json["observations"].size(), 2u);
  std::size_t points = 0;
  for (const auto& observation : json["observations"]) {
    EXPECT_EQ(observation["shots"], 6);
    EXPECT_EQ(observation["off_shots"], 1);
    std::size_t pixels = 0;
    for (const auto& count : observation["outcomes"])
      pixels += count.get<std::size_t>();
    EXPECT_EQ(pixels, 160u * 120u);
    const StereoCloud cloud =
        loadStereo(out(observation["file"].get<std::string>())).cloud;
    const auto finite = std::count_if(
        cloud.begin(), cloud.end(), [](const auto& p) { return std::isfinite(p.z); });
    EXPECT_EQ(observation["points"], finite);
    points += observation["points"].get<std::size_t>();
  }
  EXPECT_EQ(json["points"], points);
  EXPECT_TRUE(json["seconds"].contains("match"));
}

TEST_F(ActiveStereoSession, BrokenFramesAreLeftOut)
{
  input_ = copiedWithout(session(), folder_, {"frame_000003.acf"});
  std::filesystem::resize_file(input_ + "/frame_000009.acf", 2000);
  const std::string report = folder_.path("report.json");
  const ToolRun run = runSession({"--report", report}).succeeded();
  EXPECT_THAT(run.err, HasSubstr("frame 9"));
  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["broken_frames"], nlohmann::json({9}));
  EXPECT_THAT(json["findings"].dump(), HasSubstr("frame 9"));
  EXPECT_EQ(json["observations"][0]["shots"], 5);
  EXPECT_EQ(json["observations"][1]["shots"], 5);
}

TEST_F(ActiveStereoSession, AnObservationThatComesAgainIsNotOverwritten)
{
  input_ = folder_.path("mixed");
  {
    TrinocularRecorder recorder(input_, loadTrinocularRig(rig_));
    const auto frames = framesOf(session());
    for (std::size_t i = 0; i < 14; ++i) {
      // the last two shots of the first observation are at the end
      TrinocularFrame frame = *frames[i < 5 ? i : i < 12 ? i + 2 : i - 7];
      frame.number = i;
      recorder.record(frame);
    }
    recorder.finish();
  }
  const ToolRun run = runSession().succeeded();
  EXPECT_THAT(run.err, HasSubstr("observation 0: its frames from 12 on are left out"));
  EXPECT_THAT(run.out, HasSubstr("observations: 2\n"));
}

TEST_F(ActiveStereoSession, ObservationsOfWhichNothingIsLeft)
{
  // the first observation has only the shot without a pattern
  std::vector<std::string> shots;
  for (int i = 1; i < 7; ++i)
    shots.push_back("frame_00000" + std::to_string(i) + ".acf");
  input_ = copiedWithout(session(), folder_, shots);
  const ToolRun run = runSession().succeeded();
  EXPECT_THAT(run.err, HasSubstr("observation 0: "));
  const StereoCloud cloud = loadStereo(out("observation_0000.pcd")).cloud;
  ASSERT_EQ(cloud.width, 160u);
  for (const PointXYZRGBSigma& point : cloud)
    ASSERT_TRUE(std::isnan(point.z));

  std::filesystem::remove_all(out_);
  for (int i = 7; i < 14; ++i)
    std::filesystem::resize_file(
        input_ + "/frame_0000" + (i < 10 ? "0" : "") + std::to_string(i) + ".acf", 100);
  expectRefused(runSession(), 4, "no pixel has a place");
  std::filesystem::resize_file(input_ + "/frame_000000.acf", 100);
  expectRefused(runSession(), 3, "no frame that can be read");
}

/** \brief Records one shot repeatedly, each time as a separate observation. */
void
recordRepeated(const std::string& folder,
               const TrinocularRig& rig,
               TrinocularFrame frame,
               int observations)
{
  TrinocularRecorder recorder(folder, rig);
  for (int observation = 0; observation < observations; ++observation) {
    frame.number = static_cast<std::uint64_t>(observation);
    frame.observation = observation;
    recorder.record(frame);
  }
  recorder.finish();
}

TEST_F(ActiveStereoSession, AnInterruptedRunKeepsWhatIsFinished)
{
  // takes seconds, so that the run cannot finish before the interruption
  constexpr int observations = 250;
  input_ = folder_.path("recorded");
  recordRepeated(
      input_, loadTrinocularRig(rig_), *framesOf(session())[1], observations);
  RunSettings settings;
  settings.interrupt_when = [&] { return isUnfinished(out_, "observation_0001.pcd"); };
  const ToolRun run =
      runSession({"--disparity", "--min-depth", "0.05", "--threads", "1"}, settings);
  ASSERT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(run.out, "");
  const std::ptrdiff_t files =
      std::distance(std::filesystem::directory_iterator(out_), {});
  ASSERT_EQ(files % 3, 0);
  ASSERT_GE(files / 3, 2);
  ASSERT_LT(files / 3, observations);
  EXPECT_THAT(run.err, HasSubstr(out_ + ": " + std::to_string(files / 3) + "\n"));
  // all observations are the same
  const std::string first = contentOf(out("observation_0000.pcd"));
  const std::string number = std::to_string(files / 3 - 1);
  const std::string last =
      "observation_" + std::string(4 - number.size(), '0') + number + ".pcd";
  EXPECT_EQ(contentOf(out(last)), first);
  EXPECT_EQ(loadStereo(out(last)).cloud.size(), 160u * 120u);
}

} // namespace
} // namespace pcl::acmap::test
