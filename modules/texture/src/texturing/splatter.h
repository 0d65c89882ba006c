#pragma once

#include "texturing/canvas.h"

#include <pcl/texture/texturing_kernel.h>

namespace pcl::acmap::texturing {

/** Colours the texels that the points of a cloud are in with their mean: for clouds of which
 * nobody knows the camera. */
void
splat(const ColoredView& view,
      std::int32_t number,
      const std::vector<std::int32_t>& nearest,
      std::vector<Canvas>& canvases);

} // namespace pcl::acmap::texturing
