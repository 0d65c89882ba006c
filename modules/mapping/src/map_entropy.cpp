#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/mapping/impl/map_entropy.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(
    MapEntropy,
    (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
        pcl::PointNormal)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBNormalView))
