#pragma once

#include "planes/cell_graph.h"

namespace pcl::acmap::planes {

/** Root mean square heights of the waves of a surface over several edges of the mesh, metres:
 * the noise, where this is independent between points. */
struct Waves {
  double quiet = 0;  ///< exceeded on three quarters of the surface
  double height = 0; ///< exceeded on half of it
};

/** \param[in] rings edges of the mesh around a point; waves that are much longer are
 * taken for curvature */
Waves
measureWaves(const CellGraph& graph, int rings);

/** Normals of planes over some edges of the mesh around each point. */
LargeVector<Eigen::Vector3f>
normalsOverWaves(const CellGraph& graph, int rings);

} // namespace pcl::acmap::planes
