#include "json_file.h"
#include "rgbd_folders.h"
#include "run_tool.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/trajectory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** A folder of three frames, the second of which is modified. */
class UglyRgbd : public testing::Test {
protected:
  ToolRun
  run(const std::vector<std::string>& more = {}) const
  {
    return runTool(ACMAP_RGBD_IMPORT, joined({input_.path(""), "-o", output_}, more));
  }

  void
  expectRefused(const ToolRun& run, int exit_code, const std::string& word) const
  {
    test::expectRefused(run, exit_code, word);
    EXPECT_EQ(results_.count(), 0);
  }

  /** The folder is refused with the name of the file; the frame is left out if that is
   * requested. */
  void
  expectBroken(const std::string& file, const std::string& word)
  {
    SCOPED_TRACE(file + ": " + word);
    const ToolRun refused = run();
    expectRefused(refused, 3, file);
    EXPECT_THAT(refused.err, HasSubstr(word));
    const ToolRun skipped = run({"--skip-broken"}).succeeded();
    EXPECT_THAT(skipped.err, HasSubstr("warning: left out: "));
    EXPECT_THAT(skipped.err, HasSubstr(file));
    EXPECT_THAT(skipped.out, HasSubstr("observations: 2\n"));
    EXPECT_THAT(skipped.out, HasSubstr("left out:    1 broken frames\n"));
    EXPECT_EQ(loadTrajectory(output_ + "/trajectory.txt").poses.size(), 2u);
    EXPECT_TRUE(std::filesystem::exists(output_ + "/observation_0001.pcd"));
    EXPECT_FALSE(std::filesystem::exists(output_ + "/observation_0002.pcd"));
    std::filesystem::remove_all(output_);
  }

  TemporaryFolder input_;
  TemporaryFolder results_;
  std::string output_ = results_.path("observations");
};

TEST_F(UglyRgbd, BrokenImagesInTheMiddle)
{
  writeSevenScenes(input_, 3);
  const std::string depth = "frame-000010.depth.png";
  const std::string color = "frame-000010.color.png";
  const std::string good_depth = contentOf(input_.path(depth));
  const std::string good_color = contentOf(input_.path(color));
  std::filesystem::remove(input_.path(depth));
  expectBroken(depth, "No such file");
  input_.write(depth, good_depth.substr(0, good_depth.size() - 20));
  expectBroken(depth, "PNG");
  input_.write(depth, "");
  expectBroken(depth, "is empty");
  input_.write(depth, good_color);
  expectBroken(depth, "one channel");
  input_.write(depth, depthPngBytes(6, 8, tellingDepths(1)));
  expectBroken(depth, "has 6 x 8 pixels");
  input_.write(depth, good_depth);
  std::filesystem::remove(input_.path(color));
  expectBroken(color, "No such file");
  input_.write(color, "no image");
  expectBroken(color, "is no PNG, JPEG, PGM or PPM");
  input_.write(color, textOfBytes(encodePng(tellingColors(1, 9, 6))));
  expectBroken(color, "has 9 x 6 pixels");
}

TEST_F(UglyRgbd, PosesThatAreNone)
{
  writeSevenScenes(input_, 3);
  const std::string pose = "frame-000010.pose.txt";
  const Eigen::Matrix4d good = posedAt(1).matrix();
  const auto breaks = [&](const std::function<void(Eigen::Matrix4d&)>& spoil,
                          const std::string& word) {
    Eigen::Matrix4d bad = good;
    spoil(bad);
    input_.write(pose, matrixText(bad));
    expectBroken("frame-000010", word);
  };
  using Matrix = Eigen::Matrix4d;
  breaks([](Matrix& m) { m(0, 0) = std::nan(""); }, "no finite number");
  breaks([](Matrix& m) { m(1, 3) = std::numeric_limits<double>::infinity(); },
         "no finite number");
  breaks([](Matrix& m) { m.topLeftCorner<3, 3>() *= 1.2; }, "is no rigid motion");
  breaks([](Matrix& m) { m.col(0) *= -1.0; }, "is no rigid motion");
  breaks([](Matrix& m) { m.setZero(); }, "is no rigid motion");
  breaks([](Matrix& m) { m.topLeftCorner<3, 3>().setZero(); }, "is no rigid motion");
  breaks([](Matrix& m) { m(3, 3) = 2; }, "is no rigid motion");
  breaks([](Matrix& m) { m(3, 0) = 1; }, "is no rigid motion");
  breaks([](Matrix& m) { m(2, 3) = 1e30; }, "away from the origin");
  for (const char* text :
       {"", "1 0 0 0\n", "1 2 3\n4 5 6\n7 8 9\n1 1 1\n", "\x01\xff"}) {
    input_.write(pose, text);
    expectBroken(pose, pose);
  }
  std::filesystem::remove(input_.path(pose));
  expectBroken(pose, "is missing");
}

TEST_F(UglyRgbd, MapBeginsWithTheFirstWholeFrame)
{
  writeSevenScenes(input_, 3);
  input_.write("frame-000000.pose.txt", "lost");
  run({"--skip-broken"}).succeeded();
  const Trajectory trajectory = loadTrajectory(output_ + "/trajectory.txt");
  EXPECT_EQ(trajectory.stamps, (std::vector<double>{10, 20}));
  EXPECT_TRUE(trajectory.poses[0].matrix().isIdentity(0));
  EXPECT_TRUE(trajectory.poses[1].isApprox(posedAt(1).inverse() * posedAt(2), 1e-12));
}

TEST_F(UglyRgbd, ManyBrokenFramesAreNamedInTheReport)
{
  writeSevenScenes(input_, 9);
  for (int frame = 1; frame < 9; ++frame)
    input_.write("frame-0000" + std::to_string(frame) + "0.depth.png", "x");
  const std::string report = input_.path("report.json");
  const ToolRun done =
      run({"--registered", "--skip-broken", "--report", report}).succeeded();
  EXPECT_EQ(done.errorLines(), 6u) << done.err;
  EXPECT_THAT(done.err, HasSubstr("3 further frames left out"));
  EXPECT_EQ(jsonOfFile(report)["broken"].size(), 8u);
}

TEST_F(UglyRgbd, NothingLeftIsNothingFound)
{
  writeSevenScenes(input_, 2);
  input_.write("frame-000000.depth.png", "x");
  input_.write("frame-000010.color.png", "x");
  expectRefused(run({"--skip-broken"}), 4, "frame-000000.depth.png");
  for (const char* name : {"frame-000000", "frame-000010"}) {
    input_.write(std::string(name) + ".color.png",
                 textOfBytes(encodePng(tellingColors(0))));
    input_.write(
        std::string(name) + ".depth.png",
        depthPngBytes(small_width, small_height, std::vector<std::uint16_t>(48)));
  }
  expectRefused(run(), 4, "no depth image has a point");
}

TEST_F(UglyRgbd, WhatIsNoRgbdFolderIsToldWhatItWouldNeed)
{
  const ToolRun empty = run();
  expectRefused(empty, 3, "rgb.txt and depth.txt (TUM)");
  EXPECT_THAT(empty.err, HasSubstr("frame-000000.color.jpg or .png"));
  input_.write("frame-.color.png", "x");
  input_.write("frame-12x.depth.png", "x");
  input_.write("frame-000000.pose.txt", "x");
  expectRefused(run(), 3, "is no RGB-D folder");
  const auto at = [&](const std::string& path) {
    return runTool(ACMAP_RGBD_IMPORT, {path, "-o", output_});
  };
  expectRefused(at(input_.path("none")), 3, "none: is no folder");
  expectRefused(at(input_.write("file", "x")), 3, "file: is no folder");
}

TEST_F(UglyRgbd, MissingPosesAreToldAndDoneWithout)
{
  writeSevenScenes(input_, 2);
  std::filesystem::remove(input_.path("frame-000000.pose.txt"));
  std::filesystem::remove(input_.path("frame-000010.pose.txt"));
  const auto expectNoPoses = [&] {
    EXPECT_THAT(run().succeeded().err, HasSubstr("has no poses"));
    EXPECT_FALSE(std::filesystem::exists(output_ + "/trajectory.txt"));
    std::filesystem::remove_all(output_);
  };
  expectNoPoses();
  for (const auto& entry : std::filesystem::directory_iterator(input_.path("")))
    std::filesystem::remove_all(entry);
  writeTum(input_, 1);
  std::filesystem::remove(input_.path("groundtruth.txt"));
  expectNoPoses();
}

TEST_F(UglyRgbd, ListsOfTumNameFileAndLine)
{
  writeTum(input_, 3);
  const std::string colors = contentOf(input_.path("rgb.txt"));
  for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
           {"# only\n\n", "rgb.txt: is empty"},
           {"", "rgb.txt: is empty"},
           {"1 a b\n", "rgb.txt: line 1: has 3 words"},
           {"1\n", "line 1: has 1 words"},
           {"#\nx a.png\n", "line 2: 'x' is no finite number"},
           {"inf a.png\n", "'inf' is no finite number"},
           {std::string(100000, 'y') + " a.png\n", "yyy...' is no finite number"}}) {
    input_.write("rgb.txt", text);
    expectRefused(run(), 3, word);
    expectRefused(run({"--skip-broken"}), 3, word);
  }
  std::filesystem::remove(input_.path("rgb.txt"));
  expectRefused(run(), 3, "rgb.txt: is missing");
  input_.write("rgb.txt", "5 a.png\n");
  expectRefused(run(), 4, "no colour image was taken near");
  input_.write("rgb.txt", colors);
  input_.write("groundtruth.txt", "1 0 0 0 0 0 0 2\n");
  expectRefused(run(), 3, "groundtruth.txt: line 1");
  input_.write("groundtruth.txt", "1 0 0 0 0 0 0 1\n");
  expectRefused(run(), 4, "groundtruth.txt has no pose near");
}

TEST_F(UglyRgbd, ListsOfTumStayInTheFolder)
{
  writeTum(input_, 3);
  const std::string image = textOfBytes(encodePng(tellingColors(0)));
  const TemporaryFolder other;
  const std::string absolute = other.write("x.png", image);
  for (const char* list : {"rgb.txt", "depth.txt"}) {
    const std::string good = contentOf(input_.path(list));
    for (const std::string& name : {absolute,
                                    input_.path("rgb/0.png"),
                                    std::string("../x.png"),
                                    std::string(".."),
                                    std::string("rgb/../../x.png"),
                                    std::string("./../x.png")}) {
      input_.write(list, "# made\n0 " + name + "\n");
      for (const std::vector<std::string>& more :
           {std::vector<std::string>{}, {"--skip-broken"}}) {
        const ToolRun refused = run(more);
        expectRefused(
            refused, 3, std::string(list) + ": line 2: '" + name.substr(0, 8));
        EXPECT_THAT(refused.err, HasSubstr("does not lie in the folder"));
      }
    }
    input_.write(list, good);
  }
  std::string colors = contentOf(input_.path("rgb.txt"));
  const std::size_t at = colors.find("rgb/0.png");
  ASSERT_NE(at, std::string::npos);
  input_.write("rgb.txt", colors.replace(at, 9, "./depth/../rgb/0.png"));
  EXPECT_EQ(run().exit_code, 0);
}

TEST_F(UglyRgbd, ImagesOfTumThatBreak)
{
  writeTum(input_, 3);
  std::filesystem::remove(input_.path("rgb/1.png"));
  expectBroken("rgb/1.png", "No such file");
  std::filesystem::create_directory(input_.path("rgb/1.png"));
  expectBroken("rgb/1.png", "is a folder");
}

} // namespace
} // namespace pcl::acmap::test
