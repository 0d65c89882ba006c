#include "figure_plan.h"
#include "messages.h"
#include "temporary_folder.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/map_file.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/session_truth.h>
#include <pcl/pipeline/stage_store.h>
#include <pcl/simulation/scene_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string
sample(const std::string& name)
{
  return ACMAP_FORMAT_SAMPLES "/" + name;
}

TEST(Formats, MapsOfTheFirst)
{
  const CompactMap map = loadCompactMap(sample("map_1"));
  ASSERT_EQ(map.planes.size(), 1U);
  ASSERT_EQ(map.charts.size(), 1U);
  EXPECT_EQ(map.trajectory.poses.size(), 2U);
  EXPECT_NEAR(map.planes[0].coefficients[3], 1.2009586, 1e-6);
  EXPECT_EQ(map.charts[0].colors.values.size(), 3 * map.charts[0].kinds.size());
  const CompactMap planes = loadMapFile(sample("planes_1.json"));
  ASSERT_EQ(planes.planes.size(), 1U);
  EXPECT_EQ(planes.planes[0].support, 900U);
  EXPECT_TRUE(planes.planes[0].proposed.empty());
}

TEST(Formats, RigsOfTheFirst)
{
  const TrinocularRig rig = loadTrinocularRig(sample("session_1/rig.yaml"));
  EXPECT_EQ(rig.width, 96);
  EXPECT_EQ(rig.baseline_vertical, -0.1);
  const RigCalibration cameras = loadRigCalibration(sample("calibrated_rig_1.yaml"));
  EXPECT_EQ(cameras.camera(RigCamera::Reference).focal_y, 520.1);
}

TEST(Formats, SessionsOfTheFirst)
{
  TrinocularFileGrabber grabber(sample("session_1"));
  EXPECT_EQ(grabber.getRig().width, 96);
  const TrinocularFrame frame =
      loadTrinocularFrame(sample("session_1/frame_000001.acf"));
  EXPECT_EQ(frame.number, 1U);
  EXPECT_EQ(frame.images[2].values.size(), 96U * 72U * frame.images[2].channels);
  const SessionTruth truth = loadSessionTruth(sample("session_1"));
  EXPECT_EQ(truth.trajectory.poses.size(), 1U);
  EXPECT_EQ(truth.planes[0].name, "back");
}

TEST(Formats, ScenesFiguresAndCamerasOfTheFirst)
{
  EXPECT_EQ(loadSimulatedScene(sample("scene_1.yaml")).views.size(), 2U);
  EXPECT_EQ(loadFigurePlan(sample("figures_1.yaml")).observations, 106U);
  EXPECT_NO_THROW(loadColorCamera(sample("camera_1.yaml")));
}

/** Stages of earlier formats run again, and their files are known to be replaceable. */
TEST(Formats, StagesOfAllRunAgain)
{
  for (const char* name : {"stage_1.json", "stage_2.json"}) {
    const TemporaryFolder folder;
    const StageStore store(folder.path("stages"));
    fs::create_directories(store.path("a"));
    fs::copy(sample(name), store.path("a", "stage.json"));
    folder.write("stages/a/trajectory.txt", "of an earlier run");
    EXPECT_FALSE(store.find("a", StageKey()));
    store.begin("a", StageKey()).keepParts();
    EXPECT_FALSE(fs::exists(folder.path("stages/a/trajectory.txt")));
  }
}

/** Error message of a reader for a modified sample. */
std::string
faultOf(const std::string& name,
        std::size_t at,
        const std::string& put_in,
        const std::function<void(const std::string&)>& read)
{
  const TemporaryFolder folder;
  fs::copy(fs::path(sample(name)).parent_path(),
           folder.path(""),
           fs::copy_options::recursive);
  const std::string copy = folder.path(fs::path(name).filename().string());
  std::string text = contentOf(copy);
  text.insert(std::min(at, text.size()), put_in);
  folder.write(fs::path(name).filename().string(), text);
  return messageOf([&] { read(copy); }, "no fault");
}

TEST(Formats, NewerOnesAreRefusedByName)
{
  constexpr std::size_t end = 1000000;
  const auto folderOf = [](const std::string& path) {
    return fs::path(path).parent_path().string();
  };
  const std::string json = "\"format\":7,", yaml = "format: 7\n";
  const std::vector<std::string> faults = {
      faultOf("planes_1.json", 1, json, [](const auto& path) { loadMapFile(path); }),
      faultOf(
          "scene_1.yaml", 0, yaml, [](const auto& path) { loadSimulatedScene(path); }),
      faultOf("session_1/rig.yaml",
              end,
              yaml,
              [](const auto& path) { loadTrinocularRig(path); }),
      faultOf("calibrated_rig_1.yaml",
              end,
              yaml,
              [](const auto& path) { loadRigCalibration(path); }),
      faultOf("session_1/truth.json",
              1,
              json,
              [&](const auto& path) { loadSessionTruth(folderOf(path)); }),
      faultOf(
          "figures_1.yaml", 0, yaml, [](const auto& path) { loadFigurePlan(path); }),
      faultOf(
          "camera_1.yaml", 0, yaml, [](const auto& path) { loadColorCamera(path); })};
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const bool is_rig = i == 2 || i == 3;
    const std::size_t newest = i == 0   ? file_formats::map
                               : is_rig ? file_formats::rig
                                        : 1;
    EXPECT_THAT(faults[i],
                HasSubstr("written by a newer acmap (format 7; this one reads up to " +
                          std::to_string(newest) + ")"));
  }
}

TEST(Formats, NewerSessionsFramesAndStagesAreRefused)
{
  const std::string newer = "written by a newer acmap (format";
  EXPECT_THAT(faultOf("session_1/session.yaml",
                      std::string("%YAML:1.0\n---\nversion: 1").size(),
                      "7",
                      [](const auto& path) {
                        const std::string folder = fs::path(path).parent_path();
                        TrinocularFileGrabber grabber(folder);
                      }),
              HasSubstr(newer + " 17;"));
  EXPECT_THAT(faultOf("session_1/frame_000000.acf",
                      std::string("ACFRAME\n").size(),
                      std::string("\2\0\0\0", 4),
                      [](const auto& path) { loadTrinocularFrame(path); }),
              HasSubstr(newer + " 2;"));
  const TemporaryFolder folder;
  const StageStore store(folder.path(""));
  store.begin("a", StageKey()).keepParts();
  folder.write("a/stage.json", R"({"format":3,"finished":true,"results":[["a"]]})");
  EXPECT_THROW(store.find("a", StageKey()), OutputFileException);
  EXPECT_THROW(store.begin("a", StageKey()), OutputFileException);
}

TEST(Formats, NumbersThatAreNoneAreRefused)
{
  for (const char* number : {"0", "-1", "1.5", "x", "[]"})
    EXPECT_THAT(faultOf("scene_1.yaml",
                        0,
                        std::string("format: ") + number + "\n",
                        [](const auto& path) { loadSimulatedScene(path); }),
                HasSubstr("format"));
}

/** A new version number needs a sample of the previous one and an entry in the page. */
TEST(Formats, EachHasItsRowInThePage)
{
  const std::string page = contentOf(ACMAP_FORMATS_PAGE);
  const std::vector<std::pair<std::string, std::size_t>> known = {
      {"map", file_formats::map},
      {"rig", file_formats::rig},
      {"scene", file_formats::scene},
      {"session", file_formats::session},
      {"frame", file_formats::frame},
      {"truth", file_formats::truth},
      {"figures", file_formats::figures},
      {"camera", file_formats::camera},
      {"stage", file_formats::stage},
      {"report", file_formats::report},
      {"poses", file_formats::poses}};
  for (const auto& [name, newest] : known)
    EXPECT_THAT(page, HasSubstr("| `" + name + "` | " + std::to_string(newest) + " |"));
}

} // namespace
} // namespace pcl::acmap::test
