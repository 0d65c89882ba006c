#pragma once

#include "crease_truth.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief How the creases that were found lie beside the true ones. Shares from 0 to 1. */
struct CreaseScores {
  std::size_t found = 0;        ///< vertices called crease or corner
  double precision = 0;         ///< share of them in reach of a true edge
  double length = 0;            ///< metres of true edges whose both sides were seen
  double recall = 0;            ///< share of it with such a vertex in reach
  std::size_t near_edges = 0;   ///< vertices within half a voxel of these edges
  double recall_of_nearest = 0; ///< share of them that is called so
};

/** \param[in] vertices scene frame
 * \param[in] is_crease for each vertex
 * \param[in] voxel metres
 * \param[in] sigma noise of the points, metres: in reach is what is not farther than a
 * voxel and two of these */
CreaseScores
scoreCreases(const SceneTruth& truth,
             const test::Points& vertices,
             const std::vector<bool>& is_crease,
             double voxel,
             double sigma);

} // namespace pcl::acmap::bench
