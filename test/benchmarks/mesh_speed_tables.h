#pragma once

#include "simulated_clouds.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief One raw view: both rules, PCL's greedy projection and planar Delaunay, with
 * the quality of the meshes.
 * \param[in] rounds for the median; greedy projection gets 1 */
void
printViewSpeed(const SceneData& corridor, std::size_t rounds);

/** \brief All raw points of a standard scene with both rules: time, and memory in
 * addition to the input, each in a separate process. Must be called before any thread
 * is started. */
void
printMapSpeed(const std::string& standard_scene);

/** \brief Crops of the corridor, raw and consolidated: is the time per point
 * constant? */
void
printCropSpeed(SceneData& corridor);

/** \brief Consolidation of the whole corridor, and the mesh of the result. */
void
printConsolidatedSpeed(SceneData& corridor, std::size_t rounds);

/** \brief Speed-up and cost of a second thread compared with a loop without shared
 * data, and a check that the meshes do not depend on the number of threads. */
void
printThreadSpeed(SceneData& corridor);

/** \brief Loading and saving compared with plain fread and fwrite of the same size. */
void
printFileSpeed(SceneData& corridor, std::size_t rounds);

} // namespace pcl::acmap::bench
