#include <pcl/core/point_types.h>
#include <pcl/egomotion/impl/transformation_estimation_planar.hpp>
#include <pcl/point_types.h>

namespace pcl::registration {

template class ACMAP_EXPORT TransformationEstimationPlanar<PointXYZ, PointXYZ, double>;

#define ACMAP_INSTANTIATE(PointT) \
  template class ACMAP_EXPORT TransformationEstimationPlanar<PointT, PointT, float>;

ACMAP_INSTANTIATE(PointXYZ)
ACMAP_INSTANTIATE(PointXYZI)
ACMAP_INSTANTIATE(PointXYZRGB)
ACMAP_INSTANTIATE(PointXYZRGBA)
ACMAP_INSTANTIATE(PointNormal)
ACMAP_INSTANTIATE(PointXYZRGBNormal)
ACMAP_INSTANTIATE(PointXYZRGBSigma)

} // namespace pcl::registration
