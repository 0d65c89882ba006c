#pragma once

#include "texturing/sheet.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::texturing {

/** Moves the samples of all planes on their texels, as if the cameras had been moved. Samples of
 * texels that a view has not seen any more are lost.
 * \param[in] moves of each camera, in the frame of the map (\ref alignedMoves)
 * \param[in] eyes position of each camera before, metres in the frame of the map */
void
moveSamples(const std::vector<Eigen::Isometry3d>& moves,
            const std::vector<Eigen::Vector3d>& eyes,
            const std::vector<Sheet>& sheets,
            std::vector<Canvas>& canvases);

} // namespace pcl::acmap::texturing
