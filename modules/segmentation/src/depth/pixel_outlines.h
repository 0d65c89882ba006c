#pragma once

#include "planes/known_planes.h"

#include <pcl/core/depth_view.h>

namespace pcl::acmap::depth {

/** \brief Gives each plane its polygons and their area: the rims of its pixels in the
 * picture, simplified there and laid onto the plane. Gaps of a few pixels are closed.
 * \param[in] labels for each pixel its plane, -1 for none */
void
outlinePixels(const DepthView& view,
              const std::vector<std::int32_t>& labels,
              std::vector<KnownPlane>& planes);

/** \brief The point in which a ray of the view meets a plane. */
Eigen::Vector3d
meet(const Eigen::Vector3d& ray, const Eigen::Vector4d& coefficients);

} // namespace pcl::acmap::depth
