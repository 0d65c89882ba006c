#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>
#include <pcl/surface/impl/dewall_triangulation.hpp>

PCL_INSTANTIATE(DeWallTriangulation,
                (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
                    pcl::PointNormal)(pcl::PointXYZRGBNormal))
