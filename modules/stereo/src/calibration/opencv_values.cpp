#include "opencv_values.h"

#include <opencv2/calib3d.hpp>

#include <cstdio>
#include <new>

namespace pcl::acmap {

Eigen::Isometry3d
poseOf(const cv::Mat& turn, const cv::Mat& shift)
{
  cv::Matx33d rotation;
  if (turn.total() == 3)
    cv::Rodrigues(turn, rotation);
  else
    turn.copyTo(rotation);
  const Eigen::Matrix3d rows_as_columns =
      Eigen::Map<const Eigen::Matrix3d>(rotation.val);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  // The rotation from OpenCV's iterations is less accurate than double precision.
  pose.linear() = Eigen::Quaterniond(Eigen::Matrix3d(rows_as_columns.transpose()))
                      .normalized()
                      .toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    pose.translation()[i] = shift.at<double>(i);
  return pose;
}

CameraCalibration
cameraOf(const cv::Matx33d& matrix, const cv::Mat& distortion)
{
  CameraCalibration camera;
  camera.focal_x = matrix(0, 0);
  camera.focal_y = matrix(1, 1);
  camera.center_x = matrix(0, 2);
  camera.center_y = matrix(1, 2);
  for (int i = 0; i < 5; ++i)
    camera.distortion[static_cast<std::size_t>(i)] = distortion.at<double>(i);
  camera.is_there = true;
  return camera;
}

cv::Matx33d
matrixOf(const CameraCalibration& camera)
{
  return {
      camera.focal_x, 0, camera.center_x, 0, camera.focal_y, camera.center_y, 0, 0, 1};
}

void
requireMemoryWasThere(const cv::Exception& error)
{
  // cv::Mat catches the exception of its allocator and asserts that it has memory.
  if (error.code == cv::Error::StsNoMem || error.err == "u != 0")
    throw std::bad_alloc();
}

std::string
pixelText(double pixels)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f", pixels);
  return text.data();
}

} // namespace pcl::acmap
