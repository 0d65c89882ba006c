#pragma once

#include "texturing/canvas.h"

#include <vector>

namespace pcl::acmap::bench {

/** \brief Steps of brightness between neighbouring texels that were seen, of 255. */
struct SeamSteps {
  double across = 0;       ///< mean where the best samples are of two views
  double inside = 0;       ///< mean where they are of one
  std::size_t borders = 0; ///< pairs of texels of two views
};

SeamSteps
measureSeams(const std::vector<texturing::Canvas>& canvases,
             const std::vector<TextureChart>& charts);

} // namespace pcl::acmap::bench
