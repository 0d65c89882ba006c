#pragma once

#include "simulated_clouds.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief NoiseScale compared with the truth of the corridor, and on real clouds. */
void
printNoise(SceneData& corridor);

/** \brief Meshes of the consolidated corridor compared with its truth. */
void
printMesh(SceneData& corridor);

/** \brief Normals of representatives compared with PCL's NormalEstimation. */
void
printNormals(SceneData& corridor);

/** \brief Tests if both sides of a thin wall, and a door and its wall, are
 * preserved. */
void
printSheets(SceneData& corridor);

/** \brief CPU time of consolidation, its steps, its peers and a lower bound.
 * \param[in] rounds for the median; clouds above 10 million points get 3 */
void
printConsolidationTime(SceneData& corridor, std::size_t rounds);

/** \brief Peak memory of consolidating the whole corridor, in addition to the input. */
void
printConsolidationMemory(SceneData& corridor);

} // namespace pcl::acmap::bench
