#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/egomotion/impl/correspondence_estimation_log_polar.hpp>
#include <pcl/egomotion/impl/gradient_maximum_keypoint.hpp>
#include <pcl/egomotion/impl/revisit_detection.hpp>
#include <pcl/egomotion/impl/transformation_estimation_planar.hpp>
#include <pcl/egomotion/impl/visual_egomotion.hpp>

template class pcl::Keypoint<pcl::PointXYZRGBSigma, pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(CorrespondenceEstimationLogPolar, ACMAP_VIEW_POINT_TYPES)
PCL_INSTANTIATE(GradientMaximumKeypoint, ACMAP_VIEW_POINT_TYPES)
PCL_INSTANTIATE(RevisitDetection, ACMAP_VIEW_POINT_TYPES)
PCL_INSTANTIATE(VisualEgomotion, ACMAP_VIEW_POINT_TYPES)

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
