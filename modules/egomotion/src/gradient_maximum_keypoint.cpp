#include <pcl/core/point_types.h>
#include <pcl/egomotion/impl/gradient_maximum_keypoint.hpp>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

// for Keypoint of our point type, see the header
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

template class pcl::Keypoint<pcl::PointXYZRGBSigma, pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(GradientMaximumKeypoint,
                (pcl::PointXYZRGB)(pcl::PointXYZRGBA)(pcl::PointXYZRGBNormal)(
                    pcl::PointXYZRGBSigma))
