#include <pcl/core/compiled_point_types.h>
#include <pcl/features/impl/normal_vector_voting.hpp>

// for the instantiation of Feature for our point type, see the header
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

template class pcl::Feature<pcl::PointXYZRGBNormalView, pcl::Normal>;

PCL_INSTANTIATE(NormalVectorVoting, ACMAP_MAP_POINT_TYPES)
