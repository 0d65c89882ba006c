#include "figure_clouds.h"

#include "bench_data.h"
#include "mesh_checker.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

FigureCloud
makeFigureCloud(const std::string& name, test::Cloud cloud)
{
  FigureCloud result{name, std::move(cloud), 0};
  result.spacing = test::medianSpacing(test::toPoints(result.cloud));
  return result;
}

test::Cloud
loadFinite(const std::string& path)
{
  test::Cloud all;
  fromPCLPointCloud2(loadPointCloud(path).cloud, all);
  test::Cloud finite;
  for (const PointXYZ& point : all)
    if (point.getVector3fMap().allFinite())
      finite.push_back(point);
  return finite;
}

std::vector<FigureCloud>
load(const std::vector<std::pair<std::string, std::string>>& files)
{
  std::vector<FigureCloud> clouds;
  for (const auto& [name, path] : files)
    if (const std::optional<std::string> found = pathOfData(path))
      clouds.push_back(makeFigureCloud(name, loadFinite(*found)));
  return clouds;
}

} // namespace

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
  auto clouds =
      load({{"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd"},
            {"office1", "E_meshing/office1.pcd"},
            {"capture0001", "E_meshing/capture0001.pcd"}});
  clouds.push_back(
      makeFigureCloud("simulated corridor view", test::makeCorridorView(138654, 1)));
  return clouds;
}

} // namespace pcl::acmap::bench
