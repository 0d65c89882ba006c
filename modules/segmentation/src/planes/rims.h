#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Gives points beside a plane in the mesh, that lie on it but whose normals are mixed or
 * missing, to that plane: two rings of them.
 * \param[in] distance metres */
void
widenRims(const CellGraph& graph, double distance, std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
