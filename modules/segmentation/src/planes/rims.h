#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Assigns points to an adjacent plane in the mesh if they are on it but their normals
 * are mixed or missing: two rings of them.
 * \param[in] distance metres */
void
widenRims(const CellGraph& graph, double distance, std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
