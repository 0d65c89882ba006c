#include "simulated_rooms.h"

#include <pcl/simulation/simulated_observation.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

void
addWall(SimulatedScene& scene,
        const std::string& name,
        const SimulatedRectangle& rectangle)
{
  scene.geometry.addRectangle(name, name, rectangle, {});
}

} // namespace

SimulatedScene
makeEmptyScene(double noise)
{
  SimulatedScene scene;
  scene.name = "room";
  scene.rig.width = 200;
  scene.rig.height = 150;
  scene.rig.focal_length = 150;
  scene.rig.center_x = 99.5;
  scene.rig.center_y = 74.5;
  scene.sensor.points = 30000;
  scene.sensor.noise_growth = 0;
  scene.sensor.min_noise = scene.sensor.max_noise = noise;
  scene.views = {Eigen::Isometry3d::Identity()};
  return scene;
}

SimulatedScene
makeRoomCorner(double noise)
{
  SimulatedScene scene = makeEmptyScene(noise);
  addWall(scene, "far wall", {{-1.4, 1.1, 3}, {4, 0, 0}, {0, -3, 0}});
  addWall(scene, "left wall", {{-1.4, 1.1, 0}, {0, 0, 3}, {0, -3, 0}});
  addWall(scene, "floor", {{-1.4, 1.1, 0}, {4, 0, 0}, {0, 0, 3}});
  return scene;
}

SimulatedScene
makeRoomWithDoor(double noise, double depth)
{
  SimulatedScene scene = makeEmptyScene(noise);
  addWall(scene, "floor", {{-2, 1.1, 0}, {4, 0, 0}, {0, 0, 4}});
  WallOpenings door;
  door.at = {0.9};
  door.depth = depth;
  door.name = "door";
  door.floor = "floor";
  scene.geometry.addWall(
      "wall", "wall", {{-2, 1.1, 3}, {4, 0, 0}, {0, -3, 0}}, {}, door);
  scene.geometry.addBox("box", {0.5, 0.4, 2.2}, {1.2, 1.1, 2.7}, {});
  return scene;
}

SeenRoom
see(const SimulatedScene& scene, std::uint64_t seed)
{
  const MergedObservations merged = mergeObservations(scene, 0, seed);
  SeenRoom room;
  room.planes = merged.planes;
  room.cloud = std::make_shared<PointCloud<PointXYZRGBNormalView>>();
  for (std::size_t i = 0; i < merged.points.size(); ++i) {
    PointXYZRGBNormalView point;
    point.getVector3fMap() = merged.points[i];
    point.view = merged.view[i];
    room.cloud->push_back(point);
    room.truth.push_back(static_cast<std::int32_t>(merged.label[i]) - 1);
  }
  for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
    room.viewpoints.emplace_back(pose.translation().cast<float>());
  return room;
}

SeenRoom
seeSharply(SimulatedScene scene)
{
  scene.rig.width *= 2;
  scene.rig.height *= 2;
  scene.rig.focal_length *= 2;
  scene.rig.center_x = 2 * scene.rig.center_x + 0.5;
  scene.rig.center_y = 2 * scene.rig.center_y + 0.5;
  scene.sensor.points *= 4;
  return see(scene, 1);
}

std::int32_t
planeNamed(const SeenRoom& room, const std::string& name)
{
  const auto plane = std::find_if(room.planes.begin(),
                                  room.planes.end(),
                                  [&](const TruthPlane& p) { return p.name == name; });
  return static_cast<std::int32_t>(plane - room.planes.begin());
}

double
distanceTo(const TruthPlane& plane, const Eigen::Vector3d& place)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (const SimulatedRectangle& rectangle : plane.rectangles) {
    const Eigen::Vector3d off = place - rectangle.corner;
    const auto along = [&](const Eigen::Vector3d& edge) {
      return std::clamp(off.dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge;
    };
    minimum = std::min(
        minimum, (off - along(rectangle.edge_u) - along(rectangle.edge_v)).norm());
  }
  return minimum;
}

} // namespace pcl::acmap::test
