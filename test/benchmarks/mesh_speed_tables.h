#pragma once

#include "simulated_clouds.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief One raw view: both rules, PCL's greedy projection and planar Delaunay, with what
 * the meshes are worth.
 * \param[in] rounds of which the median counts; greedy projection gets 1 */
void
printViewSpeed(const SceneData& corridor, std::size_t rounds);

/** \brief All raw points of a standard scene by both rules: time, and memory on top of the
 * input, each in a process of its own. To be called before any thread was started. */
void
printMapSpeed(const std::string& standard_scene);

/** \brief Pieces of the corridor, raw and consolidated: does a point cost the same in all
 * of them? */
void
printCropSpeed(SceneData& corridor);

/** \brief Consolidation of the whole corridor and the mesh of what it gives. */
void
printConsolidatedSpeed(SceneData& corridor, std::size_t rounds);

/** \brief What a second thread gains and costs, beside a loop that shares nothing, and
 * whether the meshes depend on the number of threads. */
void
printThreadSpeed(SceneData& corridor);

/** \brief Loading and saving beside plain fread and fwrite of as many bytes. */
void
printFileSpeed(SceneData& corridor, std::size_t rounds);

} // namespace pcl::acmap::bench
