#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>
#include <pcl/segmentation/impl/plane_hypothesis_clustering.hpp>

PCL_INSTANTIATE(
    PlaneHypothesisClustering,
    (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
        pcl::PointNormal)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBNormalView))
