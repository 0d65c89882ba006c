#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>
#include <pcl/segmentation/impl/depth_plane_segmentation.hpp>

PCL_INSTANTIATE(
    DepthPlaneSegmentation,
    (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
        pcl::PointNormal)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBNormalView))
