#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <optional>
#include <string>

namespace pcl {

/** \brief Describes a plane: the sentence of \ref describePlane, and on a line each its
 * number, equation, standard deviations of slopes and offset, and support. Unknown
 * properties are marked as such.
 * \param[in] number of the plane
 * \throws BadArgumentException when the map has no such plane \ingroup visualization */
ACMAP_EXPORT std::string
planeCard(const CompactMap& map, std::size_t number);

/** \brief The same for a cylinder: \ref describeCylinder, number, side, radius, extent,
 * arc, support, area, bits.
 * \param[in] number of the cylinder
 * \throws BadArgumentException when the map has no such cylinder
 * \ingroup visualization */
ACMAP_EXPORT std::string
cylinderCard(const CompactMap& map, std::size_t number);

/** \brief The same for a box: number, template, size, what is known of its sides, bits.
 * \param[in] number of the box in its map \ingroup visualization */
ACMAP_EXPORT std::string
boxCard(const BoxPatch& box, std::size_t number);

/** \brief The same for a recess: number, template, size, wall and leaf, bits.
 * \param[in] number of the recess in its map \ingroup visualization */
ACMAP_EXPORT std::string
recessCard(const RecessPatch& recess, std::size_t number);

/** \brief Finds the first plane that a ray intersects inside its polygons.
 * \param[in] eye origin of the ray, metres
 * \param[in] direction of any length but 0
 * \param[in] fronts_only ignores planes that face away from the eye
 * \return its number in the map; nothing if there is no intersection, or a cylinder
 * before it
 * \throws BadArgumentException when eye or direction are not finite, or the direction
 * is 0
 * \ingroup visualization */
ACMAP_EXPORT std::optional<std::size_t>
planeOnRay(const CompactMap& map,
           const Eigen::Vector3d& eye,
           const Eigen::Vector3d& direction,
           bool fronts_only = false);

} // namespace pcl
