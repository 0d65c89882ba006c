// Consolidates and meshes a cloud of a custom point type, with fields that are unknown
// to acmap.
// Usage: custom_point_type [MESH.ply]

// As for any class of PCL: this file instantiates the templates for the custom type.
#define PCL_NO_PRECOMPILE

#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/random.h>
#include <pcl/filters/impl/voxel_consolidation.hpp>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>
#include <pcl/surface/impl/dewall_triangulation.hpp>

#include <cmath>
#include <cstdint>
#include <iostream>

// A measurement of a laser scanner.
struct EIGEN_ALIGN16 LaserReturn {
  PCL_ADD_POINT4D; // x y z, metres
  float reflectance = 0;
  std::uint32_t microseconds = 0; // since the start of the scan
  std::uint16_t ring = 0;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(
  LaserReturn,
  (float, x, x)
  (float, y, y)
  (float, z, z)
  (float, reflectance, reflectance)
  (std::uint32_t, microseconds, microseconds)
  (std::uint16_t, ring, ring))
// clang-format on

namespace {

using Cloud = pcl::PointCloud<LaserReturn>;

// A wall of 4 x 2 m, 3 m ahead (z), with a black board on it. The points are 1 cm apart
// and have a noise of 1 cm: a mesh of the raw points would be crumpled.
Cloud::Ptr
scanWall()
{
  pcl::acmap::Random random(1);
  Cloud::Ptr cloud(new Cloud);
  for (std::uint16_t ring = 0; ring < 200; ++ring)
    for (int column = 0; column < 400; ++column) {
      LaserReturn point;
      point.x = static_cast<float>(0.01 * (column - 199.5));
      point.y = static_cast<float>(0.01 * (ring - 99.5));
      point.z = static_cast<float>(3 + 0.01 * random.normal());
      const bool on_board = std::abs(point.x) < 1 && std::abs(point.y) < 0.5;
      point.reflectance = on_board ? 0.1F : 0.8F;
      point.microseconds = static_cast<std::uint32_t>(cloud->size()) * 10;
      point.ring = ring;
      cloud->push_back(point);
    }
  return cloud;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc > 2) {
    std::cerr << "usage: custom_point_type [MESH.ply]\n";
    return 2;
  }
  try {
    const Cloud::Ptr cloud = scanWall();

    pcl::VoxelConsolidation<LaserReturn> consolidation;
    consolidation.setInputCloud(cloud);
    consolidation.setKeepSources(true);
    const Cloud::Ptr consolidated(new Cloud);
    consolidation.filter(*consolidated);

    pcl::DeWallTriangulation<LaserReturn> dewall;
    dewall.setInputCloud(consolidated);
    dewall.setMaximumEdgeLength(2.5 * consolidation.getReport().voxel_size);
    pcl::TriangleMesh mesh;
    dewall.reconstruct(mesh);

    // x y z are new; the custom fields are those of one of the source points
    std::size_t true_copies = 0;
    const auto& sources = consolidation.getSourceIndices();
    for (std::size_t i = 0; i < consolidated->size(); ++i)
      for (std::size_t s = sources.offsets[i]; s < sources.offsets[i + 1]; ++s) {
        const LaserReturn& source = (*cloud)[sources.indices[s]];
        const LaserReturn& point = (*consolidated)[i];
        true_copies += source.microseconds == point.microseconds &&
                       source.ring == point.ring &&
                       source.reflectance == point.reflectance;
      }
    const pcl::DeWallReport& report = dewall.getReport();
    std::cout << cloud->size() << " points became " << consolidated->size()
              << ", of which " << true_copies
              << " have time, ring and reflectance of a source, and "
              << report.triangles << " triangles; " << report.boundary_edges << " of "
              << report.edges << " edges are boundary\n";
    if (argc == 2) {
      pcl::PCLPointCloud2 vertices; // with all fields, so that the file has them too
      pcl::toPCLPointCloud2(*consolidated, vertices);
      pcl::saveTriangleMesh(argv[1], vertices, mesh);
    }
    if (true_copies != consolidated->size() ||
        report.triangles < consolidated->size()) {
      std::cerr << "custom_point_type: a wall does not look like this\n";
      return 1;
    }
  }
  catch (const std::exception& e) {
    std::cerr << "custom_point_type" << e.what() << "\n";
    return 1;
  }
}
