#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/features/impl/normal_vector_voting.hpp>

// for the instantiation of Feature for our point types, see the header
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

template class pcl::Feature<pcl::PointXYZRGBNormalView, pcl::Normal>;
template class pcl::Feature<pcl::PointXYZRGBSigma, pcl::Normal>;

PCL_INSTANTIATE(NormalVectorVoting, ACMAP_ALL_POINT_TYPES)
