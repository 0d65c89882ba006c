#pragma once

#include "plan_extent.h"

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The way of the camera from above, x to the right and z upwards: a line from a dot
 * on, strokes that tell where it looked, a dashed red line with a cross an observation
 * where some are lost, a grid in metres, and a scale bar.
 * \param[in] poses T_map_camera of each observation; nothing where it is lost
 * \param[in] truth the true ones of all, drawn in grey; may be empty */
RgbImage
wayPicture(const std::vector<std::optional<Eigen::Isometry3d>>& poses,
           const std::vector<Eigen::Isometry3d>& truth);

} // namespace pcl::acmap
