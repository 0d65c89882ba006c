#pragma once

#include "texturing/canvas.h"
#include "texturing/pinhole.h"

#include <vector>

namespace pcl::acmap::texturing {

/** Offers the colours of a pinhole view to the texels it sees.
 *
 * A texel is seen where the view's own depth around its pixel is of its plane alone; at
 * depth edges it is not. Frontal, near views count
 * more than others (a pixel's area on the plane), and the middle of an image more than its
 * rim, so that views fade into each other.
 * \param[in] nearest canvas of each pixel, of \ref nearestCanvases */
void
paintPinhole(const ColoredView& view,
             const Pinhole& camera,
             std::int32_t number,
             const std::vector<std::int32_t>& nearest,
             const std::vector<PlanePatch>& planes,
             std::vector<Canvas>& canvases);

} // namespace pcl::acmap::texturing
