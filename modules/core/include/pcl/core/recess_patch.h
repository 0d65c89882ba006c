#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>

namespace pcl {

/** \brief A rectangular recess in a wall that a plane closes, the leaf: a closed door, a
 * window, a niche. \ingroup core */
struct RecessPatch {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< of the opening, metres

  /** \brief Unit directions of width, height (upwards), and the normal of the wall,
   * towards the side from which it was seen; in the columns, right-handed. */
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /** \brief Width and height of the opening, and distance from the wall back to the
   * leaf, metres. */
  Eigen::Vector3d size = Eigen::Vector3d::Zero();

  std::int32_t wall = -1;     ///< number of the plane around the opening
  std::int32_t leaf = -1;     ///< number of the plane behind it
  bool reaches_floor = false; ///< a plane of the map bounds it below, as for a door

  /** \brief Covariance of (turn about each of the axes, shift of the center along each
   * of them, size), radians and metres. It includes what a map does not tell of its
   * planes: a millimetre and a milliradian. */
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();

  /** \brief Recesses of the same number have the same size: it was fitted to all of
   * them. */
  std::int32_t template_id = 0;

  /** \brief Bits by which it shortens the description of leaf and opening. */
  double saved_bits = 0;

  std::string name; ///< such as "Closed door of room 1"; empty: not named
};

} // namespace pcl
