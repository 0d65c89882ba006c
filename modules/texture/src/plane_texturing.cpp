#include <pcl/core/point_types.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>
#include <pcl/texture/impl/plane_texturing.hpp>

PCL_INSTANTIATE(PlaneTexturing,
                (pcl::PointXYZ)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
                    pcl::PointXYZRGBNormal)(pcl::PointXYZRGBNormalView))
