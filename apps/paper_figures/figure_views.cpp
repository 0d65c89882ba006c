#include "figure_views.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

bool
isOneSurface(float a, float b, float c)
{
  constexpr float largest_step = 0.03f; // relative to the depth
  const auto [least, most] = std::minmax({a, b, c});
  return std::isfinite(a + b + c) && most - least <= largest_step * least;
}

} // namespace

TriangleMesh
surfaceOf(const PointCloud<PointXYZRGBSigma>& observation)
{
  TriangleMesh mesh;
  const auto width = static_cast<std::int32_t>(observation.width);
  const auto height = static_cast<std::int32_t>(observation.height);
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    const auto depth = [&](std::int32_t i) {
      return observation[static_cast<std::size_t>(i)].z;
    };
    if (isOneSurface(depth(a), depth(b), depth(c)))
      mesh.triangles.push_back({a, b, c});
  };
  for (std::int32_t y = 0; y + 1 < height; ++y)
    for (std::int32_t x = 0; x + 1 < width; ++x) {
      const std::int32_t corner = y * width + x;
      add(corner, corner + width, corner + 1);
      add(corner + 1, corner + width, corner + width + 1);
    }
  return mesh;
}

} // namespace pcl::acmap
