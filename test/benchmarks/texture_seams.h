#pragma once

#include "texturing/canvas.h"

#include <vector>

namespace pcl::acmap::bench {

/** \brief Brightness differences between neighbouring observed texels, of 255. */
struct SeamSteps {
  double across = 0;       ///< mean if the best samples are from two views
  double inside = 0;       ///< mean if they are from one view
  std::size_t borders = 0; ///< pairs of texels with two views
};

/** \param[in] from_rim minimum distance from the polygon's border in texels: at creases
 * and depth edges the views disagree about the extent of the plane */
SeamSteps
measureSeams(const std::vector<texturing::Canvas>& canvases,
             const std::vector<TextureChart>& charts,
             std::int32_t from_rim);

} // namespace pcl::acmap::bench
