#include <pcl/core/compiled_point_types.h>
#include <pcl/egomotion/impl/correspondence_estimation_log_polar.hpp>

// PCL has no search trees compiled for our point type, and the base calls them
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/search.hpp>

template class ACMAP_EXPORT pcl::search::KdTree<pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(CorrespondenceEstimationLogPolar, ACMAP_VIEW_POINT_TYPES)
