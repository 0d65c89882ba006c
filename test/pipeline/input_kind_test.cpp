#include "temporary_folder.h"

#include <pcl/pipeline/input_kind.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

/** \brief A folder with empty files; names that end in a slash are subfolders. */
InputKind
kindOfFolderWith(const std::vector<std::string>& names)
{
  const TemporaryFolder folder;
  for (const std::string& name : names)
    if (name.back() == '/')
      fs::create_directory(folder.path(name));
    else
      folder.write(name, "");
  return inputKindOf(folder.path(""));
}

TEST(InputKinds, OfFoldersAreToldByWhatLiesInThem)
{
  const std::vector<std::pair<InputKind, std::vector<std::string>>> cases = {
      {InputKind::Unknown, {}},
      {InputKind::Unknown, {"notes.txt", "color/"}},
      {InputKind::Images, {"L_00.png", "R_00.PNG"}},
      {InputKind::RgbdFolder, {"rgb.txt"}},
      {InputKind::RgbdFolder, {"depth.txt", "rgb.txt", "groundtruth.txt"}},
      {InputKind::RgbdFolder, {"frame-000000.color.jpg", "camera-intrinsics.txt"}},
      {InputKind::RgbdFolder, {"frame-000000.depth.png"}},
      {InputKind::RgbdFolder, {"color/", "depth/"}},
      {InputKind::RgbdFolder, {"image/", "depth/"}},
      {InputKind::RawSession, {"session.yaml", "observation_0000.pcd"}},
      {InputKind::RawSession, {"frame_000000.acf"}},
      {InputKind::CompactMap, {"map.json", "map.pcd", "trajectory.txt"}},
      {InputKind::CompactMap, {"map.json"}},
      {InputKind::MergedMap, {"map.pcd", "trajectory.txt"}},
      {InputKind::Observations, {"map.pcd"}},
      {InputKind::Observations, {"map.pcd", "observation_0000.pcd", "trajectory.txt"}},
      {InputKind::Observations, {"scan.PCD", "map.json", "rgb.txt"}}};
  for (const auto& [kind, names] : cases)
    EXPECT_EQ(kindOfFolderWith(names), kind) << testing::PrintToString(names);
}

TEST(InputKinds, OfFilesAreToldByEndingAndFirstBytes)
{
  const TemporaryFolder folder;
  const auto kind = [&](const std::string& name, const std::string& bytes) {
    return inputKindOf(folder.write(name, bytes));
  };
  const std::string scan = "# a robot\nPARAM robot_front 1\nFLASER 2 1 1 0 0 0\n";
  EXPECT_EQ(kind("a.log", ""), InputKind::CarmenLog);
  EXPECT_EQ(kind("a.clf", ""), InputKind::CarmenLog);
  EXPECT_EQ(kind("a.LOG.gz", ""), InputKind::CarmenLog);
  EXPECT_EQ(kind("a.txt", scan), InputKind::CarmenLog);
  EXPECT_EQ(kind("a.txt", "Some FLASER messages\n"), InputKind::Cloud);
  EXPECT_EQ(kind("a.gz", scan), InputKind::CarmenLog);
  EXPECT_EQ(kind("a.json", "{\"planes\": []}"), InputKind::Planes);
  EXPECT_EQ(kind("a.json", "{}"), InputKind::Unknown);
  EXPECT_EQ(kind("a.ply", ""), InputKind::Cloud);
  EXPECT_EQ(inputKindOf(folder.path("none.log")), InputKind::Unknown);
  EXPECT_EQ(inputKindOf("/dev/zero"), InputKind::Unknown);
}

} // namespace
} // namespace pcl::acmap::test
