#pragma once

#include "texturing/canvas.h"
#include "texturing/pinhole.h"

#include <vector>

namespace pcl::acmap::texturing {

/** Offers the colours of a pinhole view to the texels that it sees.
 *
 * A texel is visible if the depth around its pixel belongs to its plane only; it is
 * not visible at depth edges. Frontal and near views get larger weights than others
 * (by the area of a pixel on the plane), and the centre of an image gets larger
 * weights than its border, so that views blend into each other.
 * \param[in] nearest canvas of each pixel, from \ref nearestCanvases */
void
paintPinhole(const ColoredView& view,
             const Pinhole& camera,
             std::int32_t number,
             const std::vector<std::int32_t>& nearest,
             const std::vector<PlanePatch>& planes,
             std::vector<Canvas>& canvases);

} // namespace pcl::acmap::texturing
