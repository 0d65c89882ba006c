#include <pcl/core/fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/pose_convention.h>

namespace pcl {

namespace {

constexpr double millimetre = 0.001;

/** Axes of OpenGL's camera in those of acmap's. */
Eigen::Isometry3d
openGlAxes()
{
  Eigen::Isometry3d axes = Eigen::Isometry3d::Identity();
  axes.linear().diagonal() << 1, -1, -1;
  return axes;
}

} // namespace

Eigen::Isometry3d
readPose(const Eigen::Isometry3d& recorded, const PoseReading& reading)
{
  Eigen::Isometry3d pose = recorded;
  pose.translation() *= reading.scale;
  switch (reading.convention) {
  case PoseConvention::WorldToCamera:
    return pose.inverse();
  case PoseConvention::OpenGl:
    return pose * openGlAxes();
  case PoseConvention::OpenGlWorldToCamera:
    return pose.inverse() * openGlAxes();
  case PoseConvention::TransposedRotation:
    pose.linear().transposeInPlace();
    return pose;
  default:
    return pose;
  }
}

std::string
textOf(const PoseReading& reading)
{
  return acmap::nameIn(acmap::pose_convention_names, reading.convention) +
         std::string(", ") +
         (reading.scale == 1 ? "metres"
          : reading.scale == millimetre
              ? "millimetres"
              : "units of " + acmap::shortNumber(reading.scale) + " m");
}

} // namespace pcl
