#pragma once

#include "plan_extent.h"

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Draws the trajectory of the camera from above, x to the right and z upwards:
 * a line that starts at a dot, strokes for the directions of view, dashed red lines
 * with one cross per lost observation, a grid in metres, and a scale bar.
 * \param[in] poses T_map_camera of each observation; nothing if it is lost
 * \param[in] truth the true poses of all observations, drawn in grey; may be empty */
RgbImage
wayPicture(const std::vector<std::optional<Eigen::Isometry3d>>& poses,
           const std::vector<Eigen::Isometry3d>& truth);

} // namespace pcl::acmap
