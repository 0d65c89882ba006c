#pragma once

#include <pcl/core/cylinder_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {

/** \brief Largest distance between a drawn cylinder and its facets, metres.
 * \ingroup core */
inline constexpr double facet_tolerance = 0.001;

/** \brief Divides the surface of a cylinder into facets: narrow rectangles along its
 * axis, whose long edges are on the cylinder.
 *
 * A facet is a plane with its area and one polygon of four corners, from which it can be
 * drawn as other planes are. Its normal points to the side from which the cylinder was
 * seen. Neighbouring facets have two corners in common; those of a closed cylinder are a
 * ring. There are at least 12 for a full turn, and never more than 720.
 * \param[in] tolerance largest distance of a facet from the cylinder, metres
 * \return facets in the order of their angle from axis_u to axis_v. Empty for a cylinder
 * without an area, or whose corners are no finite floats
 * \throws BadArgumentException unless the tolerance is within [1e-9, 1e9].
 * \ingroup core */
ACMAP_EXPORT std::vector<PlanePatch>
facetsOfCylinder(const CylinderPatch& cylinder, double tolerance = facet_tolerance);

/** \brief Where the corners of a facet are in the unrolled cylinder
 * (CompactMap::cylinder_pictures).
 * \param[in] facet number of the facet
 * \param[in] facets number of facets of the cylinder
 * \return for each point of its polygon the shares of width and height, from the top
 * left. \ingroup core */
ACMAP_EXPORT std::array<Eigen::Vector2d, 4>
unrolledCorners(const CylinderPatch& cylinder, std::size_t facet, std::size_t facets);

} // namespace pcl
