#pragma once

#include <pcl/core/rig_calibration.h>

#include <opencv2/core.hpp>

#include <string>

namespace pcl::acmap {

/** \param[in] turn rotation vector or matrix */
Eigen::Isometry3d
poseOf(const cv::Mat& turn, const cv::Mat& shift);

/** \brief Creates a camera with is_there set, at the pose of the reference. */
CameraCalibration
cameraOf(const cv::Matx33d& matrix, const cv::Mat& distortion);

cv::Matx33d
matrixOf(const CameraCalibration& camera);

/** \brief Rethrows OpenCV's error as std::bad_alloc if it was caused by lack of memory.
 * \throws std::bad_alloc when OpenCV lacked memory */
void
requireMemoryWasThere(const cv::Exception& error);

/** \brief The number with two decimal places. */
std::string
pixelText(double pixels);

/** \throws InitFailedException when a camera has fewer than the minimum number of
 * boards */
void
requireEnough(const std::string& name, std::size_t views);

} // namespace pcl::acmap
