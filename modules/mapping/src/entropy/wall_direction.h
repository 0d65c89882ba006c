#pragma once

#include <pcl/core/impl/point_view.h>

namespace pcl::acmap {

/** \brief Number of wall directions of 45 degrees; the layer without direction is the
 * one after them. */
inline constexpr int wall_directions = 8;

/** \brief Maximum distance of points, metres: farther points do not belong to a
 * building; cells of nearer points fit into an integer. */
inline constexpr float entropy_reach = 1e9F;

/** \brief The direction of a wall: its unit normal in the XZ plane, towards the
 * sensor. */
struct WallDirection {
  double x = 0, z = 0;

  /** \brief Does the point belong to a wall? */
  bool
  isDirected() const
  {
    return x != 0 || z != 0;
  }

  /** \brief atan2 (z, x) */
  double
  angle() const;

  /** \brief Number of one of 32 sectors of 11.25 degrees, in no particular order. */
  int
  sector() const;
};

/** \brief Direction of the wall of point \a i, seen from the sensor at the origin;
 * undirected if the point has no normal, or if it belongs to a floor: its normal is
 * more than 45 degrees from horizontal.
 * \param[in] normals empty: none */
WallDirection
wallDirection(const PointView& points, const PointView& normals, std::size_t i);

} // namespace pcl::acmap
