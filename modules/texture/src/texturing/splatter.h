#pragma once

#include "texturing/canvas.h"

#include <pcl/texture/texturing_kernel.h>

namespace pcl::acmap::texturing {

/** Colours each texel with the mean of the points that fall into it; for clouds whose
 * camera is unknown. */
void
splat(const ColoredView& view,
      std::int32_t number,
      const std::vector<std::int32_t>& nearest,
      std::vector<Canvas>& canvases);

} // namespace pcl::acmap::texturing
