// A cloud with fewer points. Usage: voxel_grid CLOUD.pcd FEWER.pcd
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <iostream>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 3 || pcl::io::loadPCDFile(argv[1], *cloud) < 0)
    return 1;

  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud);
  filter.setLeafSize(0.05F, 0.05F, 0.05F);
  pcl::PointCloud<pcl::PointXYZ> fewer;
  filter.filter(fewer);

  std::cout << cloud->size() << " points, then " << fewer.size() << "\n";
  return pcl::io::savePCDFileBinary(argv[2], fewer) < 0 ? 1 : 0;
}
