#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <optional>
#include <string>

namespace pcl {

/** \brief What is known of a plane, a line each: number, equation, standard deviations of
 * slopes and offset, support, area, rmse. What is not known is called so.
 * \param[in] number of the plane in its map \ingroup visualization */
ACMAP_EXPORT std::string
planeCard(const PlanePatch& plane, std::size_t number);

/** \brief The first plane that a ray meets, inside of its polygons.
 * \param[in] eye where the ray begins, metres
 * \param[in] direction of any length but 0
 * \param[in] fronts_only lets the ray pass through planes that look away from the eye
 * \return its number in the map; nothing where there is none
 * \throws BadArgumentException when eye or direction are not finite, or the direction is 0
 * \ingroup visualization */
ACMAP_EXPORT std::optional<std::size_t>
planeOnRay(const CompactMap& map,
           const Eigen::Vector3d& eye,
           const Eigen::Vector3d& direction,
           bool fronts_only = false);

} // namespace pcl
