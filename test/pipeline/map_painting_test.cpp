#include "house_map.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/point_types.h>
#include <pcl/pipeline/map_painting.h>

#include <gtest/gtest.h>

#include <memory>

namespace pcl::acmap::test {
namespace {

/** A red floor of 2 m by 2 m.
 * \param[in] z of the floor, metres */
PCLPointCloud2
redFloor(float z = 0)
{
  PointCloud<PointXYZRGB> cloud;
  for (int i = 0; i <= 100; ++i)
    for (int k = 0; k <= 100; ++k) {
      PointXYZRGB point;
      point.r = 200;
      point.x = 0.02F * static_cast<float>(i);
      point.y = 0.02F * static_cast<float>(k);
      point.z = z;
      cloud.push_back(point);
    }
  PCLPointCloud2 rows;
  toPCLPointCloud2(cloud, rows);
  return rows;
}

CompactMap
floorMap()
{
  CompactMap map;
  addPlane(map, level({0, 0}, {2, 2}, 0, true));
  map.shift = {5, 6, 7};
  return map;
}

TEST(MapPainting, OneCloudHasTheColoursOfTheMap)
{
  const auto rows = std::make_shared<const PCLPointCloud2>(redFloor());
  MapPainting painting;
  painting.texturing.setTexelSize(0.05);
  std::size_t asked = 0;
  painting.cost = [&](const std::string&, std::size_t bytes, double) { asked = bytes; };
  const PaintedMap painted = paintMap(floorMap(), CloudRows(rows), painting);
  EXPECT_EQ(painted.map.planes.size(), 1U);
  EXPECT_EQ(painted.map.shift, Eigen::Vector3d(5, 6, 7));
  EXPECT_GT(painted.report.seen, 1000U);
  EXPECT_GT(asked, 0U);
  EXPECT_FALSE(painted.map.planes[0].label.name.empty());
}

std::shared_ptr<const PointCloudFile>
observedFloor()
{
  auto file = std::make_shared<PointCloudFile>();
  file->cloud = redFloor(-2); // of a sensor above it
  return file;
}

TEST(MapPainting, ObservationsHaveTheColoursOfTheMap)
{
  Trajectory trajectory{{0, 1},
                        {Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()}};
  const std::vector<std::shared_ptr<const PointCloudFile>> clouds(2, observedFloor());
  for (Eigen::Isometry3d& pose : trajectory.poses)
    pose.translation().z() = 2;
  trajectory.poses[1].translation().x() = 0.1;
  MapPainting painting;
  painting.texturing.setTexelSize(0.05);
  const PaintedMap painted =
      paintMap(floorMap(), ObservationSequence(clouds, trajectory), painting);
  EXPECT_EQ(painted.map.trajectory.poses.size(), 2U);
  EXPECT_GT(painted.report.seen, 1000U);
  EXPECT_TRUE(painted.remarks.empty());
}

TEST(MapPainting, BrokenObservationsAreLeftOutIfTheyMay)
{
  const TemporaryFolder folder;
  folder.write("observation_0000.pcd", "no cloud");
  folder.write("observation_0001.pcd", "no cloud");
  folder.write("trajectory.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  MapPainting painting;
  painting.skip_broken = true;
  for (const MapPainting& any : {MapPainting(), painting})
    EXPECT_THROW(paintMap(floorMap(), ObservationSequence(folder.path("")), any),
                 InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
