#pragma once

#include "simulated_clouds.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Normals voted for at representatives, beside their own and PCL's. */
void
printVotedNormals(SceneData& corridor);

/** \brief Creases and corners beside the true edges, by crease weight. */
void
printCreases(SceneData& corridor);

/** \brief CPU time from points to normals, beside PCL's NormalEstimation on one view.
 * \param[in] rounds of which the median counts; clouds above 10 million points get 3 */
void
printVotingTime(SceneData& corridor, std::size_t rounds);

} // namespace pcl::acmap::bench
