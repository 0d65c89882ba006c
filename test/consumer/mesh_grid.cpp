#include <pcl/core/exceptions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/point_types.h>
#include <pcl/surface/dewall_triangulation.h>

#include <iostream>

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
makeGrid(int side)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      cloud->emplace_back(0.1f * column, 0.1f * row, 1.0f);
  return cloud;
}

/** \brief Exceptions of the library must be caught by their type here. */
bool
catchesMissingFile()
{
  try {
    pcl::loadPointCloud("missing.pcd");
  }
  catch (const pcl::InputFileException&) {
    return true;
  }
  return false;
}

/** \brief Points that the library allocates are freed here. */
bool
consolidates()
{
  pcl::VoxelConsolidation<pcl::PointXYZ> consolidation;
  consolidation.setInputCloud(makeGrid(50));
  pcl::PointCloud<pcl::PointXYZ> consolidated;
  consolidation.filter(consolidated);
  return !consolidated.empty();
}

} // namespace

int
main()
{
  constexpr int side = 5;
  constexpr std::size_t expected = 2 * (side - 1) * (side - 1);

  pcl::DeWallTriangulation<pcl::PointXYZ> dewall;
  dewall.setInputCloud(makeGrid(side));
  pcl::PolygonMesh mesh;
  dewall.reconstruct(mesh);

  std::cout << mesh.polygons.size() << " triangles, " << expected << " expected\n";
  const bool is_right = mesh.polygons.size() == expected;
  return is_right && catchesMissingFile() && consolidates() ? 0 : 1;
}
