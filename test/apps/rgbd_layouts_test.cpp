#include "json_file.h"
#include "run_tool.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/trajectory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

const std::string kitchen = "C_sequence/redkitchen_000_495";
constexpr int frames = 6;

/** A layout, with the frames that are lost in it. */
struct Layout {
  const char* name;
  std::vector<int> lost;
};

/** Frames of a recording in the layouts of other programs, written by a script. */
class RealLayouts : public testing::TestWithParam<Layout> {
protected:
  void
  SetUp() override
  {
    if (!hasTestData(kitchen + "/camera-intrinsics.txt"))
      GTEST_SKIP() << kitchen << " is not in the folder that ACMAP_TEST_DATA names";
    if (std::system("python3 -c pass") != 0)
      GTEST_SKIP() << "there is no python3";
    const std::string command = "python3 " ACMAP_WRITE_LAYOUT " " +
                                std::string(GetParam().name) + " " +
                                testDataPath(kitchen).string() + " " + recording() +
                                " --frames " + std::to_string(frames);
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

  std::string
  recording() const
  {
    return folder_.path("recording");
  }

  nlohmann::json
  imported(const std::string& input,
           const std::string& output,
           const std::vector<std::string>& more = {}) const
  {
    const std::string report = folder_.path(output + ".json");
    const ToolRun run =
        runTool(ACMAP_RGBD_IMPORT,
                joined({input, "-o", folder_.path(output), "--report", report}, more));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return jsonOfFile(report);
  }

  TemporaryFolder folder_;
};

TEST_P(RealLayouts, GiveTheSamePosesAndDepths)
{
  const std::string first = folder_.path("frames");
  std::filesystem::create_directory(first);
  std::filesystem::copy(testDataPath(kitchen + "/camera-intrinsics.txt"),
                        first + "/camera-intrinsics.txt");
  for (int frame = 0; frame < frames; ++frame)
    for (const char* ending : {".color.jpg", ".depth.png", ".pose.txt"}) {
      const std::string name = "/frame-0000" + std::to_string(frame) + "0" + ending;
      std::filesystem::copy(testDataPath(kitchen + name), first + name);
    }
  const auto original = imported(first, "original", {"--registered"});
  const auto other = imported(recording(), "other");
  const std::size_t lost = GetParam().lost.size();
  EXPECT_EQ(other["observations"], frames - lost);
  EXPECT_NEAR(other["median_depth"].get<double>(),
              original["median_depth"].get<double>(),
              lost > 0 ? 0.05 : 0.003);
  const Trajectory wanted = loadTrajectory(folder_.path("original/trajectory.txt"));
  const Trajectory found = loadTrajectory(folder_.path("other/trajectory.txt"));
  std::size_t next = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const auto& all_lost = GetParam().lost;
    if (std::count(all_lost.begin(), all_lost.end(), frame) > 0)
      continue;
    ASSERT_LT(next, found.poses.size());
    EXPECT_TRUE(
        found.poses[next].isApprox(wanted.poses[static_cast<std::size_t>(frame)], 1e-4))
        << frame;
    ++next;
  }
}

INSTANTIATE_TEST_SUITE_P(OfOthers,
                         RealLayouts,
                         testing::Values(Layout{"orb_slam", {}},
                                         Layout{"times", {2, 5}},
                                         Layout{"open3d", {}},
                                         Layout{"scannet", {3}},
                                         Layout{"replica", {}},
                                         Layout{"stray", {}},
                                         Layout{"record3d", {}}),
                         [](const auto& layout) { return layout.param.name; });

TEST(RealRecordings, WithListsOfTumInMillimetresAreTold)
{
  const std::string recording = "H_field/recordings/tum_lists_in_mm";
  if (!hasTestData(recording + "/rgb.txt"))
    GTEST_SKIP() << recording << " is not in the folder that ACMAP_TEST_DATA names";
  const TemporaryFolder folder;
  const std::string input = testDataPath(recording).string();
  const ToolRun assumed =
      runTool(ACMAP_RGBD_IMPORT, {input, "-o", folder.path("assumed")}).succeeded();
  EXPECT_THAT(assumed.err, HasSubstr("--depth-scale states another"));
  const ToolRun stated =
      runTool(ACMAP_RGBD_IMPORT,
              {input, "-o", folder.path("stated"), "--depth-scale", "1000"})
          .succeeded();
  EXPECT_THAT(stated.err, testing::Not(HasSubstr("--depth-scale")));
  EXPECT_THAT(stated.out, HasSubstr("median depth: 1.17 m"));
}

} // namespace
} // namespace pcl::acmap::test
