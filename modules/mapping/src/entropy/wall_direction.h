#pragma once

#include <pcl/core/point_view.h>

namespace pcl::acmap {

/** \brief Directions of 45 degrees each; a layer without direction follows them. */
inline constexpr int wall_directions = 8;

/** \brief Farther points are none of a building; nearer ones have cells that fit in an
 * integer. */
inline constexpr float entropy_reach = 1e9F;

/** \brief The direction of a wall: its normal in the XZ plane, unit, towards the
 * sensor. */
struct WallDirection {
  double x = 0, z = 0;

  /** \brief False: of no wall. */
  bool
  isDirected() const
  {
    return x != 0 || z != 0;
  }

  /** \brief atan2 (z, x) */
  double
  angle() const;

  /** \brief Which of 32 sectors of 11.25 degrees, in no particular order. */
  int
  sector() const;
};

/** \brief The wall that point \a i lies on, seen from the sensor at the origin; undirected
 * where the point has no normal, or one of a floor: farther than 45 degrees from level.
 * \param[in] normals empty: none */
WallDirection
wallDirection(const PointView& points, const PointView& normals, std::size_t i);

} // namespace pcl::acmap
