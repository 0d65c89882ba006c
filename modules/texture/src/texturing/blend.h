#pragma once

#include "texturing/canvas.h"

namespace pcl::acmap::texturing {

/** Colours the chart of a canvas. The samples of each texel are brought to a common
 * exposure; the colour is the mean of those that agree with the weighted median. So an
 * object that is visible in one view only leaves no trace where other views saw the
 * wall. */
void
blend(const std::vector<double>& gains, const Canvas& canvas, TextureChart& chart);

/** Colours texels without a sample from their neighbours, ring by ring from the border
 * of the observed texels: at most \a distance texels, and the rim of the polygon one
 * texel further. */
void
fillHoles(int distance, const std::vector<TexelPlace>& mask, TextureChart& chart);

} // namespace pcl::acmap::texturing
