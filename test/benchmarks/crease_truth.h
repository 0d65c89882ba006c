#pragma once

#include "scene_truth.h"

namespace pcl::acmap::bench {

/** \brief A short piece of an edge where two rectangles of a scene meet at an angle. */
struct EdgePiece {
  Eigen::Vector3d place; ///< its centre, scene frame
  double length = 0;     ///< metres, about a centimetre
  std::size_t first = 0; ///< index in the truth's surfaces
  std::size_t second = 0;
};

/** \brief All edges of rectangles that touch another rectangle; each one is included
 * once. */
std::vector<EdgePiece>
edgePieces(const SceneTruth& truth);

/** \brief Was enough of both sides observed for a mesh to show the edge? The minimum is
 * a quarter of a voxel's face, within a voxel of the piece.
 * \param[in] voxel metres */
bool
isSeen(const SceneTruth& truth, const EdgePiece& piece, double voxel);

} // namespace pcl::acmap::bench
