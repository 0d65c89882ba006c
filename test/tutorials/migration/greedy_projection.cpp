// The mesh of a cloud. Usage: greedy_projection CLOUD.pcd MESH.ply
#include <pcl/common/io.h>
#include <pcl/features/normal_3d.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/surface/gp3.h>

#include <iostream>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 3 || pcl::io::loadPCDFile(argv[1], *points) < 0)
    return 1;

  pcl::PointCloud<pcl::Normal> normals;
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(points);
  estimation.setKSearch(20);
  estimation.compute(normals);
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  pcl::concatenateFields(*points, normals, *cloud);

  pcl::GreedyProjectionTriangulation<pcl::PointNormal> triangulation;
  triangulation.setSearchRadius(0.1);
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(100);
  triangulation.setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  triangulation.reconstruct(mesh);

  std::cout << mesh.polygons.size() << " triangles\n";
  return pcl::io::savePLYFile(argv[2], mesh) < 0 ? 1 : 0;
}
