#include "json_file.h"
#include "rendered_boards.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/image_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::size_t shot_count = 7;

std::string
pngOf(const CameraImage& image)
{
  const std::vector<std::uint8_t> bytes =
      encodePng(image.width, image.height, image.values);
  return {bytes.begin(), bytes.end()};
}

/** \brief A folder with board images of three cameras. */
class RigCalibrationTool : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    const std::vector<TrinocularFrame> shots = boardShots(builtRig(), shot_count);
    for (std::size_t shot = 0; shot < shot_count; ++shot)
      for (std::size_t i = 0; i < 3; ++i)
        folder_->write(shotNames(shot)[i], pngOf(shots[shot].images[i]));
    const CameraImage& any = shots.front().images.front();
    folder_->write(
        "empty_room.png",
        pngOf({640, 480, 1, std::vector<std::uint8_t>(any.values.size(), 90)}));
  }

  static void
  TearDownTestSuite()
  {
    delete folder_;
    folder_ = nullptr;
  }

  RigCalibrationTool()
  {
    for (std::size_t shot = 0; shot < shot_count; ++shot)
      for (std::size_t i = 0; i < 3; ++i)
        images_[i].push_back(folder_->path(shotNames(shot)[i]));
  }

  ToolRun
  run(const std::vector<std::string>& more = {}) const
  {
    return runWithSquare("0.03", more);
  }

  ToolRun
  runWithSquare(const std::string& side,
                const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> all = {"--square", side, "-o", rig()};
    const std::array<const char*, 3> names = {
        "--reference", "--horizontal", "--vertical"};
    for (std::size_t i = 0; i < 3; ++i) {
      if (images_[i].empty())
        continue;
      all.emplace_back(names[i]);
      all.insert(all.end(), images_[i].begin(), images_[i].end());
    }
    all.insert(all.end(), more.begin(), more.end());
    return runTool(ACMAP_RIG_CALIBRATION, all);
  }

  void
  expectRefused(const ToolRun& run, int exit_code, const std::string& word) const
  {
    test::expectRefused(run, exit_code, word);
    EXPECT_EQ(results_.count(), 0);
  }

  std::string
  rig() const
  {
    return results_.path("rig.yaml");
  }

  static TemporaryFolder* folder_;
  TemporaryFolder results_;
  std::array<std::vector<std::string>, 3> images_;
};

TemporaryFolder* RigCalibrationTool::folder_ = nullptr;

TEST_F(RigCalibrationTool, ASessionCountsAsItsImages)
{
  const TemporaryFolder recorded;
  const std::string session = recorded.path("boards");
  {
    TrinocularRecorder recorder(session, TrinocularRig());
    for (std::size_t shot = 0; shot < shot_count; ++shot) {
      TrinocularFrame frame;
      frame.number = shot;
      frame.observation = static_cast<std::int32_t>(shot);
      for (std::size_t i = 0; i < 3; ++i)
        frame.images[i] = loadCameraImage(images_[i][shot]);
      recorder.record(frame);
    }
    recorder.finish();
  }
  run().succeeded();
  const std::string of_images = contentOf(rig());
  const std::vector<std::string> arguments = {
      "--session", session, "--square", "0.03", "-o", rig()};
  runTool(ACMAP_RIG_CALIBRATION, arguments).succeeded();
  EXPECT_EQ(contentOf(rig()), of_images);
  std::filesystem::remove(rig());
  expectRefused(run({"--session", session}), 2, "either");
}

TEST_F(RigCalibrationTool, BoardsBecomeARig)
{
  images_[1][2] = folder_->path("empty_room.png");
  const std::string report = results_.path("report.json");
  const ToolRun done = run({"--board", "9x6", "--report", report}).succeeded();
  EXPECT_THAT(done.err,
              HasSubstr("empty_room.png: no whole board of 9 x 6 corners found"));
  EXPECT_THAT(done.err, HasSubstr("camera has only 7 good boards"));
  EXPECT_THAT(done.out, HasSubstr("reference:   7 boards, reprojection 0.0"));
  EXPECT_THAT(done.out, HasSubstr("horizontal:  6 boards, reprojection 0.0"));
  EXPECT_THAT(done.out, HasSubstr("rows:        0."));
  EXPECT_THAT(done.out, HasSubstr("columns:     0."));
  EXPECT_THAT(done.out, HasSubstr("file:        " + rig()));

  const RigCalibration cameras = loadRigCalibration(rig());
  EXPECT_NEAR(cameras.camera(RigCamera::Reference).focal_x, 520, 5);
  const TrinocularRig rectified = loadTrinocularRig(rig());
  EXPECT_NEAR(rectified.baseline_horizontal, -0.1, 0.002);
  EXPECT_NEAR(rectified.baseline_vertical, -0.1, 0.002);

  const auto json = jsonOfFile(report);
  EXPECT_LT(json["row_residual"], 0.15);
  EXPECT_LT(json["column_residual"], 0.15);
  EXPECT_EQ(json["cameras"]["vertical"]["boards"], 7);
  ASSERT_EQ(json["images"].size(), 3 * shot_count);
  std::size_t left_out = 0;
  for (const auto& image : json["images"])
    left_out += image.contains("left_out") ? 1 : 0;
  EXPECT_EQ(left_out, 1u);
}

TEST_F(RigCalibrationTool, ListsThatDoNotGoTogetherAreRefused)
{
  images_[2].pop_back();
  expectRefused(run(), 2, "7, 7 and 6 images");
  images_[2] = images_[1];
  expectRefused(run(), 2, "stands twice");
  images_[1].clear();
  images_[2].clear();
  expectRefused(run(), 2, "--horizontal or --vertical");
  images_[1] = {""};
  expectRefused(run(), 2, "--horizontal: an image without a name");
  expectRefused(
      runTool(ACMAP_RIG_CALIBRATION, {"-o", rig(), "--reference", "--square", "0.03"}),
      2,
      "--reference: images are missing before --square");
}

TEST_F(RigCalibrationTool, BoardsThatAreNoneAreRefused)
{
  expectRefused(run({"--board", "9x7"}), 2, "upside down");
  for (const char* board : {"9", "x", "9x", "9x6x2", "-9x6", "2x3", "nine", ""})
    expectRefused(run({"--board", board}), 2, "--board");
  for (const char* side : {"0", "-1", "30", "nan"})
    expectRefused(runWithSquare(side), 2, "it must be within [0.0001, 10] m");
  expectRefused(runWithSquare("30mm"), 2, "--square = 30mm");
  expectRefused(run({"--board", "9999x6"}), 2, "columns of the board");
  images_[0].resize(1);
  images_[1].resize(1);
  images_[2].clear();
  expectRefused(run({"--board", "10x7"}), 4, "reference camera has 0 good boards");
  expectRefused(run({"--board", "10x7"}), 4, "--board counts inner corners");
}

TEST_F(RigCalibrationTool, TooFewBoardsAreNothingFound)
{
  for (auto& list : images_)
    list.resize(4);
  const ToolRun few = run();
  expectRefused(few, 4, "has 4 good boards, at least 5 are needed");
  EXPECT_THAT(few.err, Not(HasSubstr("inner corners")));
}

TEST_F(RigCalibrationTool, BrokenFilesAreNamed)
{
  images_[0][0] = folder_->write("broken.png", "\x89PNG\r\n\x1a\n");
  expectRefused(run(), 3, "broken.png");
  images_[0][0] = folder_->path("none.png");
  expectRefused(run(), 3, "none.png");
}

TEST_F(RigCalibrationTool, OutputMustBeWritable)
{
  for (auto& list : images_)
    list.resize(1);
  std::vector<std::string> all = {"--square", "0.03", "--reference"};
  all.push_back(images_[0][0]);
  all.insert(all.end(), {"--horizontal", images_[1][0], "-o"});
  for (const char* place : {"none/rig.yaml", "rig.png"}) {
    std::vector<std::string> arguments = all;
    arguments.push_back(results_.path(place));
    expectRefused(runTool(ACMAP_RIG_CALIBRATION, arguments), 5, place);
  }
}

} // namespace
} // namespace pcl::acmap::test
