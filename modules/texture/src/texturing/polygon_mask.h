#pragma once

#include <pcl/core/compact_map.h>

#include <vector>

namespace pcl::acmap::texturing {

/** Which texels of a chart its polygon needs. */
enum class TexelPlace : std::uint8_t {
  Outside = 0,
  Rim =
      1, ///< beside an inner one: interpolation at the polygon's edge asks for its colour
  Inside = 2 ///< its middle is inside
};

/** One a texel, rows from the top. */
std::vector<TexelPlace>
maskOf(const TextureChart& chart, const PlanePolygon& polygon);

} // namespace pcl::acmap::texturing
