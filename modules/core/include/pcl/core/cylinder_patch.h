#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/surface_label.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A column, a pipe or a curved wall: a part of a cylinder with its attributes.
 * \ingroup core */
struct CylinderPatch {
  /** \brief On the axis, at the middle of the support; metres. */
  Eigen::Vector3d axis_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_direction = Eigen::Vector3d::UnitZ(); ///< unit; sign arbitrary
  double radius = 0;                                         ///< metres

  /** \brief The surface was seen from inside, as a curved niche is. */
  bool is_hollow = false;

  /** \brief Two axes across the cylinder: axis_u, axis_v and axis_direction are a
   * right-handed basis. axis_u points to the middle of the arc that was seen. */
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();

  /** \brief Extent of the support along the axis, from axis_point; metres. */
  double low = 0;
  double high = 0;

  /** \brief Angle that contains the support, centred at axis_u; radians, up to 2 pi. */
  double arc = 0;

  /** \brief Covariance of (shift of axis_point along axis_u, along axis_v, tilt of
   * axis_direction towards axis_u, towards axis_v, radius); metres and radians. NaN if
   * the support is too small to estimate it. */
  Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();

  std::size_t support = 0; ///< number of points

  /** \brief Root mean square of the distances of the support; metres, along the rays of
   * the sensors where these are known, else from the surface. */
  double rms = 0;
  double area = 0; ///< square metres, arc times radius times extent

  /** \brief Cylinders of the same number have the same radius: it was fitted to all of
   * them. Numbers ascend from 0. */
  std::int32_t template_id = 0;

  /** \brief Bits by which it shortens the description of its points. */
  double saved_bits = 0;

  /** \brief Numbers of the planes that it stands for, in those that were given. */
  std::vector<std::int32_t> planes;

  SurfaceLabel label; ///< what it is in its building, once the map has rooms
};

} // namespace pcl
