#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/features/impl/normal_vector_voting.hpp>

template class pcl::Feature<pcl::PointXYZRGBNormalView, pcl::Normal>;
template class pcl::Feature<pcl::PointXYZRGBSigma, pcl::Normal>;

PCL_INSTANTIATE(NormalVectorVoting, ACMAP_ALL_POINT_TYPES)
