#pragma once

#include <pcl/core/compact_map.h>

#include <vector>

namespace pcl::acmap::texturing {

/** Which texels of a chart belong to its polygon. */
enum class TexelPlace : std::uint8_t {
  Outside = 0,
  Rim = 1,   ///< next to an inner texel; interpolation at the polygon's edge needs its
             ///< colour
  Inside = 2 ///< its centre is inside
};

/** One value per texel, in row-major order from the top. */
std::vector<TexelPlace>
maskOf(const TextureChart& chart, const PlanePolygon& polygon);

} // namespace pcl::acmap::texturing
