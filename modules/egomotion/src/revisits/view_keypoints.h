#pragma once

#include "chain/feature_pairs.h"

#include <pcl/egomotion/impl/egomotion_kernel.h>

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A point of a view that may be recognised from elsewhere. */
struct PlaceKeypoint {
  std::int32_t pixel;
  Eigen::Vector3d place;      ///< metres
  Eigen::Matrix3d covariance; ///< m^2
};

/** \brief Keypoints of a view with their binary descriptors (ORB), which do not depend
 * on the rotation about the optical axis, and little on the distance. */
struct ViewKeypoints {
  std::vector<PlaceKeypoint> keypoints;
  cv::Mat descriptors; ///< a row of 32 bytes per keypoint
};

/** \param[in] view must have sigmas */
ViewKeypoints
keypointsOf(const CameraView& view);

/** \brief Pairs of keypoints that are each other's nearest, and clearly nearer than the
 * second one. */
std::vector<FeaturePair>
alikePairs(const ViewKeypoints& source, const ViewKeypoints& target);

} // namespace pcl::acmap
