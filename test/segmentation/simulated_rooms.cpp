#include "simulated_rooms.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/surface/dewall_kernel.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

using MapPoint = PointXYZRGBNormalView;

/** For each patch the plane that most of its points are of. */
std::vector<std::int32_t>
truthOfPatches(const Clustered& found, const SeenRoom& room)
{
  std::vector<std::vector<std::size_t>> counts(
      found.patches.size(), std::vector<std::size_t>(room.planes.size() + 1, 0));
  for (std::size_t i = 0; i < found.source_labels.size(); ++i)
    if (found.source_labels[i] >= 0)
      ++counts[static_cast<std::size_t>(found.source_labels[i])]
              [static_cast<std::size_t>(room.truth[i] + 1)];
  std::vector<std::int32_t> truth;
  for (const auto& count : counts)
    truth.push_back(static_cast<std::int32_t>(
        std::max_element(count.begin(), count.end()) - count.begin() - 1));
  return truth;
}

/** The class is not compiled for points with a view. */
TriangleMesh
meshOf(const PointCloud<MapPoint>& cloud, double longest_edge)
{
  DeWallSettings settings;
  settings.maximum_edge_length = longest_edge;
  settings.normals = PointView(cloud.front().normal, sizeof(MapPoint), cloud.size());
  DeWallReport report;
  return triangulateDeWall(PointView(&cloud.front().x, sizeof(MapPoint), cloud.size()),
                           settings,
                           Progress(),
                           report);
}

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
  scene.sensor.least_noise = scene.sensor.most_noise = noise;
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
  room.cloud = std::make_shared<PointCloud<MapPoint>>();
  for (std::size_t i = 0; i < merged.points.size(); ++i) {
    MapPoint point;
    point.getVector3fMap() = merged.points[i];
    point.view = merged.view[i];
    room.cloud->push_back(point);
    room.truth.push_back(static_cast<std::int32_t>(merged.label[i]) - 1);
  }
  for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
    room.viewpoints.emplace_back(pose.translation().cast<float>());
  return room;
}

RoomPlanes
findPlanes(const SeenRoom& room,
           const std::function<void(PlaneHypothesisClustering<MapPoint>&)>& set)
{
  VoxelConsolidation<MapPoint> consolidation;
  consolidation.setInputCloud(room.cloud);
  consolidation.setViewpoints(room.viewpoints);
  const auto cloud = std::make_shared<PointCloud<MapPoint>>();
  consolidation.filter(*cloud);
  RoomPlanes result;
  result.voxel = consolidation.getReport().voxel_size;

  const TriangleMesh mesh = meshOf(*cloud, 2.5 * result.voxel);
  NormalVectorVoting<MapPoint> voting;
  voting.setInputCloud(cloud);
  voting.setTriangles(mesh);
  voting.setViewpoints(room.viewpoints);
  const auto normals = std::make_shared<PointCloud<Normal>>();
  voting.compute(*normals);
  const auto classes = std::make_shared<PointCloud<Label>>();
  voting.getVertexClasses(*classes);

  PlaneHypothesisClustering<MapPoint> clustering;
  clustering.setInputCloud(cloud);
  clustering.setInputNormals(normals);
  clustering.setVertexClasses(classes);
  clustering.setTriangles(mesh);
  clustering.setNoiseDriven(true);
  const PointCloud<MapPoint>::ConstPtr source = room.cloud;
  clustering.setSourceCloud(source, room.viewpoints);
  set(clustering);
  static_cast<Clustered&>(result) = runClustering(clustering);
  result.truth = truthOfPatches(result, room);
  return result;
}

} // namespace pcl::acmap::test
