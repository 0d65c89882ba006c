#pragma once

#include "crease_truth.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief Comparison of detected and true creases. Fractions are from 0 to 1. */
struct CreaseScores {
  std::size_t found = 0;        ///< vertices classified as crease or corner
  double precision = 0;         ///< fraction of them within reach of a true edge
  double length = 0;            ///< metres of true edges of which both sides were
                                ///< observed
  double recall = 0;            ///< fraction of them with such a vertex within reach
  std::size_t near_edges = 0;   ///< vertices within half a voxel of these edges
  double recall_of_nearest = 0; ///< fraction of these that is classified so
};

/** \param[in] vertices in the scene frame
 * \param[in] is_crease for each vertex
 * \param[in] voxel metres
 * \param[in] sigma noise of the points, metres; the reach is a voxel plus two sigma */
CreaseScores
scoreCreases(const SceneTruth& truth,
             const test::Points& vertices,
             const std::vector<bool>& is_crease,
             double voxel,
             double sigma);

} // namespace pcl::acmap::bench
