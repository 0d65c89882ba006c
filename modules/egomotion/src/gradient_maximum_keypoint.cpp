#include <pcl/core/compiled_point_types.h>
#include <pcl/egomotion/impl/gradient_maximum_keypoint.hpp>

// Required for Keypoint of PointXYZRGBSigma, see the header.
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

template class pcl::Keypoint<pcl::PointXYZRGBSigma, pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(GradientMaximumKeypoint, ACMAP_VIEW_POINT_TYPES)
