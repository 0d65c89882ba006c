// The planes of an organized cloud. Usage: organized_planes VIEW.pcd
#include <pcl/features/integral_image_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <cmath>
#include <iostream>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) < 0)
    return 1;

  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setNormalSmoothingSize(10);
  estimation.setInputCloud(cloud);
  estimation.compute(*normals);

  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> planes;
  planes.setMinInliers(1000);
  planes.setInputNormals(normals);
  planes.setInputCloud(cloud);
  std::vector<pcl::ModelCoefficients> coefficients;
  std::vector<pcl::PointIndices> inliers;
  planes.segment(coefficients, inliers);

  for (std::size_t i = 0; i < inliers.size(); ++i) {
    double curvature = 0;
    for (const int index : inliers[i].indices)
      if (std::isfinite((*normals)[index].curvature))
        curvature += (*normals)[index].curvature / inliers[i].indices.size();
    for (const float value : coefficients[i].values)
      std::cout << value << " ";
    std::cout << "on " << inliers[i].indices.size() << " points, curvature "
              << curvature << "\n";
  }
  std::cout << inliers.size() << " planes\n";
}
