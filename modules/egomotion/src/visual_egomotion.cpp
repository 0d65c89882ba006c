#include <pcl/core/point_types.h>
#include <pcl/egomotion/impl/visual_egomotion.hpp>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

PCL_INSTANTIATE(VisualEgomotion,
                (pcl::PointXYZRGB)(pcl::PointXYZRGBA)(pcl::PointXYZRGBNormal)(
                    pcl::PointXYZRGBSigma))
