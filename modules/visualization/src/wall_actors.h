#pragma once

#include "scene_renderer.h"

#include <string>

namespace pcl::acmap {

/** \brief The triangles that the walls of steps up to one have made: those of this step
 * in the full colour of their depth, those of earlier ones in a pale one; at the last
 * step all others too, grey. The points of the mesh are faint behind them.
 * \param[in] scene with wall depths
 * \param[in] steps of the whole mesh */
Actors
actorsOfWalls(const Scene& scene, std::size_t step, std::size_t steps, bool hide_backs);

/** \brief What a step shows, a line. */
std::string
describeWalls(const TriangleMesh& mesh, std::size_t step);

} // namespace pcl::acmap
