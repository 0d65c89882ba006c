#pragma once

#include <pcl/core/rig_calibration.h>

#include <opencv2/core.hpp>

#include <string>

namespace pcl::acmap {

/** \param[in] turn rotation vector or matrix */
Eigen::Isometry3d
poseOf(const cv::Mat& turn, const cv::Mat& shift);

/** \brief A camera that is there, at the place of the reference. */
CameraCalibration
cameraOf(const cv::Matx33d& matrix, const cv::Mat& distortion);

cv::Matx33d
matrixOf(const CameraCalibration& camera);

/** \brief Tells of want of memory as everybody does.
 * \throws std::bad_alloc when OpenCV lacked memory */
void
requireMemoryWasThere(const cv::Exception& error);

/** \brief Two digits after the point. */
std::string
pixelText(double pixels);

/** \throws InitFailedException when a camera has fewer than the least boards */
void
requireEnough(const std::string& name, std::size_t views);

} // namespace pcl::acmap
