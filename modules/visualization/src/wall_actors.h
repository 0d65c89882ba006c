#pragma once

#include "scene_renderer.h"

#include <string>

namespace pcl::acmap {

/** \brief The triangles that were constructed by the walls up to a step: those of this
 * step in the full colour of their depth, those of earlier steps in a pale one; at the
 * last step all others in grey. The points of the mesh are shown faintly.
 * \param[in] scene with wall depths
 * \param[in] steps of the whole mesh */
Actors
actorsOfWalls(const Scene& scene, std::size_t step, std::size_t steps, bool hide_backs);

/** \brief Describes a step in one line. */
std::string
describeWalls(const TriangleMesh& mesh, std::size_t step);

} // namespace pcl::acmap
