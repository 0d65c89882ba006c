#pragma once

#include "triangle_builder.h"

namespace pcl::acmap::dewall {

/** \brief Completes what the parts left open, in one thread: edges whose apex is
 * outside of their half, fans at the walls, and the surroundings of such changes.
 *
 * \param[in] mesh of all points
 * \param[in] removed triangles that were removed before
 * \return number of triangles removed to keep one fan per vertex */
std::size_t
finishMesh(GrowingMesh& mesh,
           const SizeConstraint& size,
           DeWallRule rule,
           std::vector<Part>& parts,
           std::vector<GrownTriangle> removed,
           const std::function<void()>& tick);

} // namespace pcl::acmap::dewall
