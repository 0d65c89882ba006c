#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

// PCL's base classes call the search trees of their point type. PCL has none for those of
// acmap; they are compiled here once, which takes most of the time of such a class.
#define ACMAP_INSTANTIATE(PointT)                          \
  template class ACMAP_EXPORT pcl::KdTreeFLANN<PointT>;    \
  template class ACMAP_EXPORT pcl::search::Search<PointT>; \
  template class ACMAP_EXPORT pcl::search::KdTree<PointT>; \
  template class ACMAP_EXPORT pcl::search::OrganizedNeighbor<PointT>;

ACMAP_INSTANTIATE(pcl::PointXYZRGBNormalView)
ACMAP_INSTANTIATE(pcl::PointXYZRGBSigma)
