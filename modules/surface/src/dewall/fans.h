#pragma once

#include "growing_mesh.h"

namespace pcl::acmap::dewall {

/** \brief Takes out what is not in the largest fan of a pinched vertex, and what that
 * pinches in turn.
 *
 * \param[in] lists all triangles at the vertices looked at; those taken out leave them
 * \param[in] are_walls_known false passes over vertices that walls use
 * \return the triangles taken out */
std::vector<GrownTriangle>
keepLargestFans(GrowingMesh& mesh,
                const std::vector<std::vector<GrownTriangle>*>& lists,
                bool are_walls_known);

} // namespace pcl::acmap::dewall
