#include "run_tool.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/map_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/trajectory_error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

const std::string kitchen = "C_sequence/redkitchen_000_495";
constexpr std::size_t frames = 12;

/** Links the first frames of the recording, and the camera. */
void
linkFrames(const std::filesystem::path& folder)
{
  const std::filesystem::path recording = testDataPath(kitchen);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(recording))
    if (entry.path().filename().string().rfind("frame-", 0) == 0)
      files.push_back(entry.path().filename());
  std::sort(files.begin(), files.end());
  files.resize(3 * frames); // colour, depth and pose of each frame
  files.emplace_back("camera-intrinsics.txt");
  std::filesystem::create_directory(folder);
  for (const auto& file : files)
    std::filesystem::create_symlink(recording / file, folder / file);
}

/** Does the map have a plane like this one, within drift and noise? */
bool
holdsLike(const CompactMap& map, const PlanePatch& wanted)
{
  constexpr double alike = 0.9976, nearest = 0.03; // cosine of 4 degrees; metres
  return std::any_of(
      map.planes.begin(), map.planes.end(), [&wanted](const PlanePatch& plane) {
        const Eigen::Vector3d normal = plane.coefficients.head<3>();
        return normal.dot(wanted.coefficients.head<3>()) > alike &&
               std::abs(normal.dot(wanted.center) + plane.coefficients[3]) < nearest &&
               plane.area > 0.5 * wanted.area;
      });
}

/** Frames of a hand-held recording: only images, then egomotion, then a map. */
TEST(RgbdChain, ImagesAloneGiveTheMapThatPosesGive)
{
  if (!hasTestData(kitchen + "/camera-intrinsics.txt"))
    GTEST_SKIP() << kitchen << " is not in the folder that ACMAP_TEST_DATA names";
  const TemporaryFolder folder;
  const auto run = [](const char* tool, const std::vector<std::string>& arguments) {
    runTool(tool, arguments).succeeded();
  };
  const std::string recording = folder.path("recording");
  linkFrames(recording);
  const std::string posed = folder.path("posed"), bare = folder.path("bare"),
                    moved = folder.path("moved");
  run(ACMAP_RGBD_IMPORT, {recording, "-o", posed});
  run(ACMAP_RGBD_IMPORT, {recording, "-o", bare, "--no-poses"});
  EXPECT_FALSE(std::filesystem::exists(bare + "/trajectory.txt"));
  run(ACMAP_VISUAL_EGOMOTION, {bare, "-o", moved, "--6dof"});
  for (const std::string& poses : {posed, moved})
    run(ACMAP_COMPACT_MAPPING,
        {poses, "-o", poses + "_map", "--no-rectification", "--no-pictures"});

  const Trajectory given = loadTrajectory(posed + "/trajectory.txt");
  const Trajectory found = loadTrajectory(moved + "/trajectory.txt");
  ASSERT_EQ(given.poses.size(), frames);
  ASSERT_EQ(found.poses.size(), frames);
  const RelativePoseError error = relativePoseError(found.poses, given.poses);
  EXPECT_LT(error.translation_rms, 0.03);
  EXPECT_LT(error.rotation_rms, 0.02);
  const RelativePoseError still = relativePoseError(
      std::vector<Eigen::Isometry3d>(frames, Eigen::Isometry3d::Identity()),
      given.poses);
  EXPECT_LT(error.translation_rms, 0.5 * still.translation_rms);
  EXPECT_LT(absoluteTrajectoryError(found.poses, given.poses).unaligned, 0.05);

  const CompactMap expected = loadMapFile(posed + "_map/map.json");
  const CompactMap map = loadMapFile(moved + "_map/map.json");
  int large = 0; // the table, the cupboard's front, the floor, a wall
  for (std::size_t i = 0; i < expected.planes.size(); ++i)
    if (expected.planes[i].area > 0.45) {
      ++large;
      EXPECT_TRUE(holdsLike(map, expected.planes[i])) << i;
    }
  EXPECT_GE(large, 3);
}

} // namespace
} // namespace pcl::acmap::test
