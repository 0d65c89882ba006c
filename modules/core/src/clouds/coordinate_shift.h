#pragma once

#include <pcl/core/point_cloud_file.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace pcl::acmap {

/** \brief Whole kilometres to subtract along the axes along which float32 would lose
 * millimetres.
 * \param[in] first point of a file, finite */
inline Eigen::Vector3d
coordinateShift(const Eigen::Vector3d& first)
{
  constexpr double farthest = 10000, step = 1000; // metres
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(first[axis]) > farthest)
      shift[axis] = step * std::floor(first[axis] / step);
  return shift;
}

/** \brief Notes what was subtracted from the coordinates, with a remark if that is not 0. */
inline void
setShift(const Eigen::Vector3d& shift, PointCloudFile& file)
{
  file.shift = shift;
  if (shift.isZero(0))
    return;
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    text += (axis > 0 ? ", " : "") + std::to_string(std::llround(shift[axis]));
  file.remarks.push_back("its coordinates are those of the file less " + text +
                         ", so that they keep their millimetres");
}

} // namespace pcl::acmap
