#include <pcl/core/point_types.h>
#include <pcl/egomotion/impl/correspondence_estimation_log_polar.hpp>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

// PCL has no search trees compiled for our point type, and the base calls them
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/search.hpp>

template class ACMAP_EXPORT pcl::search::KdTree<pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(CorrespondenceEstimationLogPolar,
                (pcl::PointXYZRGB)(pcl::PointXYZRGBA)(pcl::PointXYZRGBNormal)(
                    pcl::PointXYZRGBSigma))
