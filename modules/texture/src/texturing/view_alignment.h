#pragma once

#include "texturing/sheet.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::texturing {

/** Moves that bring what the views show of the planes onto each other: one rigid motion of each
 * camera, in the frame of the map. It finds them in the samples of the texels, and needs no image
 * again: from coarse to fine, each camera is moved such that its samples agree with the mean of
 * the others (Gauss-Newton on brightness, robust).
 * \param[in] sheets of planes and cylinders
 * \param[in] eyes position of each camera, metres in the frame of the map
 * \param[in] gains of the views
 * \return of each view; nothing if the samples do not agree clearly better then */
std::vector<Eigen::Isometry3d>
alignedMoves(const std::vector<Canvas>& canvases,
             const std::vector<Sheet>& sheets,
             const std::vector<Eigen::Vector3d>& eyes,
             const std::vector<double>& gains);

} // namespace pcl::acmap::texturing
