#include <pcl/core/compiled_point_types.h>
#include <pcl/egomotion/impl/correspondence_estimation_log_polar.hpp>

// PCL provides no search trees for this point type, but the base class calls them.
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/search.hpp>

template class ACMAP_EXPORT pcl::search::KdTree<pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(CorrespondenceEstimationLogPolar, ACMAP_VIEW_POINT_TYPES)
