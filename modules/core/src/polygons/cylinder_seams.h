#pragma once

#include <pcl/core/cylinder_patch.h>
#include <pcl/core/plane_patch.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Joins a cylinder to the planes that its axis is parallel to, as a curved wall is
 * joined to the flat ones beside it: they meet in a line. The arc of the cylinder ends there
 * afterwards, and so do the polygons; points that other planes have too move along their
 * edges.
 * \param[in] tolerance metres
 * \param[in] number of the cylinder
 * \return number of lines */
std::size_t
joinAlongAxis(double tolerance,
              std::size_t number,
              CylinderPatch& cylinder,
              std::vector<PlanePatch>& planes);

} // namespace pcl::acmap
