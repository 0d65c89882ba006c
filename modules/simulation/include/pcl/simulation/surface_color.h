#pragma once

#include <pcl/core/export.h>
#include <pcl/simulation/scene_geometry.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl {

/** \brief Coordinates of a point on its surface, metres: along the two edges of a
 * rectangle, around and along a cylinder, across a disc. \ingroup simulation */
ACMAP_EXPORT Eigen::Vector2d
surfaceCoordinates(const SimulatedSurface& surface, const Eigen::Vector3d& point);

/** \brief Colour of a point on a surface, without light and shadow: the look's colour
 * plus texture, which is value noise in grey levels with cells of 16 cm and of 2 cm. A
 * point has the same colour in every view.
 * \param[in] surface of the scene
 * \param[in] index of the surface in its scene: each surface has a different texture
 * \param[in] point on the surface, in the scene's frame
 * \return red, green, blue \ingroup simulation */
ACMAP_EXPORT std::array<std::uint8_t, 3>
surfaceColor(const SimulatedSurface& surface,
             std::size_t index,
             const Eigen::Vector3d& point);

} // namespace pcl
