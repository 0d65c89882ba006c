#pragma once

#include "planes/known_planes.h"

#include <pcl/core/depth_view.h>

namespace pcl::acmap::depth {

/** \brief Sets the polygons of each plane and their area: the boundaries of its pixels
 * are simplified in the image and projected onto the plane. Gaps of a few pixels are
 * closed.
 * \param[in] labels for each pixel its plane, -1 for none */
void
outlinePixels(const DepthView& view,
              const std::vector<std::int32_t>& labels,
              std::vector<KnownPlane>& planes);

/** \brief Returns the intersection of a ray of the view with a plane. */
Eigen::Vector3d
meet(const Eigen::Vector3d& ray, const Eigen::Vector4d& coefficients);

} // namespace pcl::acmap::depth
