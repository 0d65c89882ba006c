#pragma once

#include <pcl/mapping/entropy_rectification_types.h>

namespace pcl::acmap {

/** \brief Standard deviation of each component of a motion of some metres. */
inline double
lengthSigma(const OdometryNoise& noise, double length)
{
  return noise.length + noise.length_per_metre * length;
}

/** \brief Standard deviation of a turn by a positive angle, radians. */
inline double
turnSigma(const OdometryNoise& noise, double angle)
{
  return noise.turn + noise.turn_per_radian * angle;
}

} // namespace pcl::acmap
