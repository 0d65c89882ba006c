#pragma once

#include "growing_mesh.h"

namespace pcl::acmap::dewall {

/** \brief Removes the triangles that are not in the largest fan of a pinched vertex,
 * and repeats this for vertices that are pinched by the removal.
 *
 * \param[in] lists all triangles at the tested vertices; the removed ones are erased
 * from them
 * \param[in] are_walls_known if false, vertices that are used by walls are skipped
 * \return the removed triangles */
std::vector<GrownTriangle>
keepLargestFans(GrowingMesh& mesh,
                const std::vector<std::vector<GrownTriangle>*>& lists,
                bool are_walls_known);

} // namespace pcl::acmap::dewall
