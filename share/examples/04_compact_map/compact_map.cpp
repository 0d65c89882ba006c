// From clouds with poses to a compact map, class by class. pcl_compact_mapping does the
// same after it has estimated the poses.
// Usage: compact_map FOLDER [VIEWS]   2 to 40, default 12

#include <pcl/common/transforms.h>
#include <pcl/conversions.h>
#include <pcl/core/point_types.h>
#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/plane_texturing.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

// An observation is an organized cloud in the frame of its camera, with a colour at
// each pixel. Each point of the map stores the number of its observation.
using Observation = pcl::PointCloud<pcl::PointXYZRGB>;
using MapPoint = pcl::PointXYZRGBNormalView;
using MapCloud = pcl::PointCloud<MapPoint>;

struct Sequence {
  std::vector<Observation::Ptr> observations;
  pcl::Trajectory trajectory; // T_map_camera

  std::vector<Eigen::Vector3f>
  viewpoints() const
  {
    std::vector<Eigen::Vector3f> places;
    for (const Eigen::Isometry3d& pose : trajectory.poses)
      places.push_back(pose.translation().cast<float>());
    return places;
  }
};

// Your data would come from files: pcl::loadPointCloud, pcl::loadTrajectory.
Sequence
lookRound(std::size_t views)
{
  const pcl::SimulatedScene office = pcl::standardScene("office");
  Sequence sequence;
  sequence.trajectory = pcl::trajectoryOf(office, views);
  for (std::size_t i = 0; i < views; ++i) {
    sequence.observations.emplace_back(new Observation);
    pcl::fromPCLPointCloud2(pcl::cloudOf(pcl::observe(office, i, 1)),
                            *sequence.observations.back());
  }
  return sequence;
}

// All finite points in the frame of the map.
MapCloud::Ptr
merged(const Sequence& sequence)
{
  MapCloud::Ptr map(new MapCloud);
  for (std::size_t i = 0; i < sequence.observations.size(); ++i) {
    const Eigen::Isometry3f T_map_camera = sequence.trajectory.poses[i].cast<float>();
    for (const pcl::PointXYZRGB& seen : *sequence.observations[i]) {
      if (!seen.getVector3fMap().allFinite())
        continue;
      MapPoint point;
      point.getVector3fMap() = T_map_camera * seen.getVector3fMap();
      point.rgba = seen.rgba;
      point.view = static_cast<std::int32_t>(i);
      map->push_back(point);
    }
  }
  return map;
}

// The noise of such clouds exceeds their point spacing. So they are consolidated to one
// point per voxel first; then a mesh of these points votes for normals and creases.
std::vector<pcl::PlanePatch>
planesOf(const MapCloud::Ptr& cloud, const std::vector<Eigen::Vector3f>& viewpoints)
{
  pcl::VoxelConsolidation<MapPoint> consolidation;
  consolidation.setInputCloud(cloud);
  consolidation.setViewpoints(viewpoints);
  const MapCloud::Ptr consolidated(new MapCloud);
  consolidation.filter(*consolidated);
  const double voxel = consolidation.getReport().voxel_size;
  std::cout << cloud->size() << " points, " << consolidated->size() << " in voxels of "
            << voxel << " m\n";

  // the mesher is compiled for PCL's types; its mesh contains point indices only, so it
  // is valid for both clouds
  const pcl::PointCloud<pcl::PointNormal>::Ptr vertices(
      new pcl::PointCloud<pcl::PointNormal>);
  pcl::copyPointCloud(*consolidated, *vertices);
  pcl::DeWallTriangulation<pcl::PointNormal> dewall;
  dewall.setInputCloud(vertices);
  dewall.setMaximumEdgeLength(2.5 * voxel);
  pcl::TriangleMesh mesh;
  dewall.reconstruct(mesh);
  std::cout << mesh.triangles.size() << " triangles, "
            << dewall.getReport().boundary_edges << " of " << dewall.getReport().edges
            << " edges are boundary\n";

  pcl::NormalVectorVoting<MapPoint> voting;
  voting.setInputCloud(consolidated);
  voting.setTriangles(mesh);
  voting.setViewpoints(viewpoints);
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  voting.compute(*normals);
  const pcl::PointCloud<pcl::Label>::Ptr classes(new pcl::PointCloud<pcl::Label>);
  voting.getVertexClasses(*classes);

  pcl::PlaneHypothesisClustering<MapPoint> clustering;
  clustering.setInputCloud(consolidated);
  clustering.setInputNormals(normals);
  clustering.setVertexClasses(classes);
  clustering.setTriangles(mesh);
  clustering.setNoiseDriven(true); // instead of the paper's thresholds
  clustering.setSourceCloud(cloud, viewpoints);
  std::vector<pcl::PlanePatch> planes;
  clustering.segment(planes);
  for (const std::string& remark : clustering.getReport().remarks)
    std::cout << remark << "\n";
  return planes;
}

pcl::CompactMap
painted(const std::vector<pcl::PlanePatch>& planes, const Sequence& sequence)
{
  pcl::PlaneTexturing<pcl::PointXYZRGB> texturing;
  texturing.setPlanes(planes);
  for (std::size_t i = 0; i < sequence.observations.size(); ++i)
    texturing.addObservation(sequence.observations[i], sequence.trajectory.poses[i]);
  pcl::CompactMap map;
  texturing.texture(map);
  map.trajectory = sequence.trajectory;
  const pcl::TexturingReport& report = texturing.getReport();
  std::cout << map.planes.size() << " planes; of " << report.texels << " texels "
            << report.seen << " seen, " << report.filled << " filled\n";
  return map;
}

} // namespace

int
main(int argc, char** argv)
{
  const int views = argc == 3 ? std::atoi(argv[2]) : 12;
  if (argc < 2 || argc > 3 || views < 2 || views > 40) {
    std::cerr << "usage: compact_map FOLDER [VIEWS]   2 to 40, default 12\n";
    return 2;
  }
  try {
    const Sequence sequence = lookRound(static_cast<std::size_t>(views));
    const std::vector<pcl::PlanePatch> planes =
        planesOf(merged(sequence), sequence.viewpoints());
    pcl::CompactMap map = painted(planes, sequence);
    for (const std::string& name : pcl::saveCompactMap(argv[1], map))
      if (name.find("texture_") != 0)
        std::cout << argv[1] << "/" << name << "\n";
    // at least floor, ceiling and one wall
    if (planes.size() < 3 || planes[0].area < 1) {
      std::cerr << "compact_map: this is no room\n";
      return 1;
    }
  }
  catch (const std::exception& e) {
    std::cerr << "compact_map" << e.what() << "\n";
    return 1;
  }
}
