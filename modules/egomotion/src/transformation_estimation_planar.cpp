#include <pcl/core/compiled_point_types.h>
#include <pcl/egomotion/impl/transformation_estimation_planar.hpp>

namespace pcl::registration {

template class ACMAP_EXPORT TransformationEstimationPlanar<PointXYZ, PointXYZ, double>;

#define ACMAP_INSTANTIATE(PointT) \
  template class ACMAP_EXPORT TransformationEstimationPlanar<PointT, PointT, float>;

ACMAP_INSTANTIATE(PointXYZ)
ACMAP_INSTANTIATE(PointXYZRGBSigma)
#ifndef ACMAP_FEW_POINT_TYPES
ACMAP_INSTANTIATE(PointXYZI)
ACMAP_INSTANTIATE(PointXYZRGB)
ACMAP_INSTANTIATE(PointXYZRGBA)
ACMAP_INSTANTIATE(PointNormal)
ACMAP_INSTANTIATE(PointXYZRGBNormal)
#endif

} // namespace pcl::registration
