#pragma once

#include <limits>

namespace pcl {

/** \brief How accurate the planes of a map are in relation to each other. The covariance of a
 * plane is that of independent noise alone; what its planes owe to the poses and to the scale
 * is here. NaN: not known, as for a single cloud. \ingroup core */
struct MapAccuracy {
  /** \brief Standard deviation of the position of an observation, along any axis, independent
   * of the other observations; metres. */
  double pose = std::numeric_limits<double>::quiet_NaN();

  /** \brief Standard deviation by which two observations are wrong with respect to each other,
   * for each metre between them. */
  double drift = std::numeric_limits<double>::quiet_NaN();

  /** \brief Relative standard deviation of all lengths. */
  double scale = std::numeric_limits<double>::quiet_NaN();
};

} // namespace pcl
