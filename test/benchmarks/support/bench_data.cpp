#include "bench_data.h"

#include "mesh_checker.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

bool
isPacked(const std::string& path)
{
  return std::filesystem::path(path).extension() == ".xz";
}

FigureCloud
withSpacing(const std::string& name, const test::Cloud& cloud)
{
  return {name, cloud, test::medianSpacing(test::toPoints(cloud))};
}

std::vector<FigureCloud>
load(const std::vector<std::pair<std::string, std::string>>& files)
{
  std::vector<FigureCloud> clouds;
  for (const auto& [name, path] : files)
    if (const std::optional<std::string> found = pathOfData(path))
      clouds.push_back(loadFigureCloud(name, *found));
  return clouds;
}

} // namespace

std::optional<std::string>
pathOfData(const std::string& relative)
{
  if (test::hasTestData(relative))
    return test::testDataPath(relative).string();
  std::cerr << "left out: no " << relative << " in ACMAP_TEST_DATA\n";
  return std::nullopt;
}

std::optional<std::string>
pathOfKitchen()
{
  const auto pose = pathOfData("C_sequence/redkitchen_000_495/frame-000000.pose.txt");
  if (!pose)
    return std::nullopt;
  return std::filesystem::path(*pose).parent_path().string();
}

std::string
contentOf(const std::string& path)
{
  const std::string command = (isPacked(path) ? "xz -dkc '" : "cat '") + path + "'";
  FILE* const pipe = ::popen(command.c_str(), "r");
  std::string content;
  std::array<char, 1 << 16> bytes;
  for (std::size_t got;
       pipe && (got = ::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    content.append(bytes.data(), got);
  if (!pipe || ::pclose(pipe) != 0)
    throw InputFileException(path + " was not read: is there an xz?");
  return content;
}

PointCloudFile
loadMaybePacked(const std::string& path)
{
  if (!isPacked(path))
    return loadPointCloud(path);
  const test::TemporaryFolder folder;
  const std::string unpacked = folder.path("cloud.ply");
  std::ofstream(unpacked, std::ios::binary) << contentOf(path);
  return loadPointCloud(unpacked);
}

FigureCloud
loadFigureCloud(const std::string& name, const std::string& path)
{
  test::Cloud all, finite;
  fromPCLPointCloud2(loadPointCloud(path).cloud, all);
  for (const PointXYZ& point : all)
    if (point.getVector3fMap().allFinite())
      finite.push_back(point);
  return withSpacing(name, finite);
}

std::vector<FigureCloud>
realClouds()
{
  return load({{"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd"},
               {"office1", "E_meshing/office1.pcd"},
               {"capture0001", "E_meshing/capture0001.pcd"},
               {"room_scan1", "C_sequence/pcl_room_scans/room_scan1.pcd"},
               {"stanford-bunny", "E_meshing/stanford-bunny.obj"}});
}

std::vector<FigureCloud>
singleViews()
{
  std::vector<FigureCloud> clouds =
      load({{"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd"},
            {"office1", "E_meshing/office1.pcd"},
            {"capture0001", "E_meshing/capture0001.pcd"}});
  clouds.push_back(
      withSpacing("simulated corridor view", test::makeCorridorView(138654, 1)));
  return clouds;
}

} // namespace pcl::acmap::bench
