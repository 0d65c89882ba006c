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

/** \param[in] from_rim only texels that are so many from the polygon's rim: at creases and
 * depth edges views differ in what they take for the plane */
SeamSteps
measureSeams(const std::vector<texturing::Canvas>& canvases,
             const std::vector<TextureChart>& charts,
             std::int32_t from_rim);

} // namespace pcl::acmap::bench
