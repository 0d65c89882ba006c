#pragma once

#include <pcl/core/point_view.h>

namespace pcl::acmap {

/** \brief Directions of 45 degrees each; a layer without direction follows them. */
inline constexpr int wall_directions = 8;

/** \brief Farther points are none of a building; nearer ones have cells that fit in an
 * integer. */
inline constexpr float entropy_reach = 1e9F;

/** \brief Direction atan2 (n_z, n_x) of the wall that point \a i lies on, towards the
 * sensor at the origin; NaN where it has no normal, or one of a floor: farther than 45
 * degrees from level.
 * \param[in] normals empty: none */
double
wallDirection(const PointView& points, const PointView& normals, std::size_t i);

} // namespace pcl::acmap
