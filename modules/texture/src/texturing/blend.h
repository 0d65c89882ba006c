#pragma once

#include "texturing/canvas.h"

namespace pcl::acmap::texturing {

/** Colours the canvas's chart: each texel from its samples, brought to one exposure; the mean of
 * those that agree with the weighted median, so that a stranger in one view leaves no
 * trace where others saw the wall. */
void
blend(const std::vector<double>& gains, const Canvas& canvas, TextureChart& chart);

/** Colours texels without a sample after their neighbours, ring by ring from the rims of
 * what was seen; \a distance texels
 * at most, and the rim of the polygon one further. */
void
fillHoles(int distance, const std::vector<TexelPlace>& mask, TextureChart& chart);

} // namespace pcl::acmap::texturing
