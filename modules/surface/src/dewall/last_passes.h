#pragma once

#include "triangle_builder.h"

namespace pcl::acmap::dewall {

/** \brief What the parts left open, in one thread: sides whose apex lies beyond their
 * half, fans at the walls, and what these change.
 *
 * \param[in] mesh of all points
 * \param[in] removed triangles taken out before
 * \return triangles removed to leave one fan a vertex */
std::size_t
finishMesh(GrowingMesh& mesh,
           const SizeConstraint& size,
           DeWallRule rule,
           std::vector<Part>& parts,
           std::vector<GrownTriangle> removed,
           const std::function<void()>& tick);

} // namespace pcl::acmap::dewall
