#include <pcl/core/point_types.h>
#include <pcl/features/impl/normal_vector_voting.hpp>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

// for Feature of our point type, see the header
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

template class pcl::Feature<pcl::PointXYZRGBNormalView, pcl::Normal>;

PCL_INSTANTIATE(
    NormalVectorVoting,
    (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(
        pcl::PointNormal)(pcl::PointXYZRGBNormal)(pcl::PointXYZRGBNormalView))
