#pragma once

#include "simulated_clouds.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief NoiseScale against the truth of the corridor, and on real clouds. */
void
printNoise(SceneData& corridor);

/** \brief Meshes of the consolidated corridor against its truth. */
void
printMesh(SceneData& corridor);

/** \brief Normals of representatives beside those of PCL's NormalEstimation. */
void
printNormals(SceneData& corridor);

/** \brief Both sides of a thin wall, and a door and its wall: are they kept, and where? */
void
printSheets(SceneData& corridor);

/** \brief CPU time of consolidation, its parts, its peers and a lower bound.
 * \param[in] rounds of which the median counts; clouds above 10 million points get 3 */
void
printConsolidationTime(SceneData& corridor, std::size_t rounds);

/** \brief Most memory that consolidating the whole corridor takes on top of it. */
void
printConsolidationMemory(SceneData& corridor);

} // namespace pcl::acmap::bench
