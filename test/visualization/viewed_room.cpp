#include "viewed_room.h"

#include "clouds.h"
#include "room_map.h"

#include <pcl/conversions.h>

namespace pcl::acmap::test {

LayeredScene
makeViewedRoom()
{
  LayeredScene scene;
  scene.map = makeRoomMap();
  scene.map.trajectory = makeRoomWay();
  scene.trajectory_before = scene.map.trajectory;
  for (Eigen::Isometry3d& pose : scene.trajectory_before.poses)
    pose.translation().y() -= 1;
  PointCloud<ViewedPoint> points;
  for (std::size_t i = 0; i < scene.map.trajectory.poses.size(); ++i)
    for (const float side : {-0.5F, 0.5F}) {
      ViewedPoint point;
      point.getVector3fMap() =
          scene.map.trajectory.poses[i].translation().cast<float>() +
          Eigen::Vector3f(0, 0.5F, side);
      point.view = static_cast<std::int32_t>(i);
      points.push_back(point);
    }
  toPCLPointCloud2(points, scene.points);
  Cloud strip;
  for (int i = 0; i < 6; ++i)
    strip.emplace_back(static_cast<float>(i) - 2, 0.5F, i % 2 == 0 ? -1.F : 1.F);
  toPCLPointCloud2(strip, scene.vertices);
  scene.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  scene.mesh.wall_depth = {0, 1, 2, TriangleMesh::no_wall};
  return scene;
}

PointCloud<ViewedPoint>
typed(const PCLPointCloud2& cloud)
{
  PointCloud<ViewedPoint> points;
  fromPCLPointCloud2(cloud, points);
  return points;
}

} // namespace pcl::acmap::test
