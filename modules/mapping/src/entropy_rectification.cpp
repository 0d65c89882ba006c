#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/mapping/impl/entropy_rectification.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(
    EntropyRectification,
    (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
        pcl::PointNormal)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBNormalView))
