// The planes of a cloud, one after the other. Usage: largest_planes CLOUD.pcd
#include <pcl/filters/extract_indices.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <iostream>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) < 0)
    return 1;

  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients(true);
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setDistanceThreshold(0.02);

  pcl::ExtractIndices<pcl::PointXYZ> extraction;
  extraction.setNegative(true);
  const std::size_t enough = cloud->size() / 20;
  int planes = 0;
  while (true) {
    pcl::PointIndices::Ptr inliers(new pcl::PointIndices);
    pcl::ModelCoefficients coefficients;
    segmentation.setInputCloud(cloud);
    segmentation.segment(*inliers, coefficients);
    if (inliers->indices.size() < enough)
      break;
    ++planes;
    for (const float value : coefficients.values)
      std::cout << value << " ";
    std::cout << "on " << inliers->indices.size() << " points\n";

    pcl::PointCloud<pcl::PointXYZ>::Ptr rest(new pcl::PointCloud<pcl::PointXYZ>);
    extraction.setInputCloud(cloud);
    extraction.setIndices(inliers);
    extraction.filter(*rest);
    cloud = rest;
  }
  std::cout << planes << " planes, " << cloud->size() << " points on none\n";
}
