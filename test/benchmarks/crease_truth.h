#pragma once

#include "scene_truth.h"

namespace pcl::acmap::bench {

/** \brief A short piece of an edge where two rectangles of a scene meet at an angle. */
struct EdgePiece {
  Eigen::Vector3d place; ///< its middle, scene frame
  double length = 0;     ///< metres, about a centimetre
  std::size_t first = 0; ///< of the truth's surfaces
  std::size_t second = 0;
};

/** \brief All edges of rectangles that lie on another one, each stretch once. */
std::vector<EdgePiece>
edgePieces(const SceneTruth& truth);

/** \brief Whether so much of both sides was seen that a mesh can show the edge: a quarter of
 * a voxel's face, within a voxel of the piece.
 * \param[in] voxel metres */
bool
isSeen(const SceneTruth& truth, const EdgePiece& piece, double voxel);

} // namespace pcl::acmap::bench
