#pragma once

#include "simulated_clouds.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Voted normals of representatives compared with their own normals and
 * PCL's. */
void
printVotedNormals(SceneData& corridor);

/** \brief Creases and corners compared with the true edges, by crease weight. */
void
printCreases(SceneData& corridor);

/** \brief CPU time from points to normals, compared with PCL's NormalEstimation on one
 * view.
 * \param[in] rounds for the median; clouds above 10 million points get 3 */
void
printVotingTime(SceneData& corridor, std::size_t rounds);

} // namespace pcl::acmap::bench
