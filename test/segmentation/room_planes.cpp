#include "room_planes.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/surface/impl/dewall_kernel.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

using MapPoint = PointXYZRGBNormalView;

/** For each patch the true plane of most of its points. */
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

/** Uses the kernel, as the class is not instantiated for points with a view. */
TriangleMesh
meshOf(const PointCloud<MapPoint>& cloud, double longest_edge)
{
  DeWallSettings settings;
  settings.maximum_edge_length = longest_edge;
  DeWallInput input;
  input.points = PointView(&cloud.front().x, sizeof(MapPoint), cloud.size());
  input.normals = PointView(cloud.front().normal, sizeof(MapPoint), cloud.size());
  DeWallReport report;
  return triangulateDeWall(input, settings, Progress(), report);
}

} // namespace

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
  clustering.setSourceCloud(room.cloud, room.viewpoints);
  set(clustering);
  static_cast<Clustered&>(result) = runClustering(clustering);
  result.truth = truthOfPatches(result, room);
  return result;
}

const PlanePatch*
patchOf(const RoomPlanes& found, std::int32_t plane)
{
  for (std::size_t p = 0; p < found.patches.size(); ++p)
    if (found.truth[p] == plane)
      return &found.patches[p];
  return nullptr;
}

} // namespace pcl::acmap::test
