#pragma once

#include <pcl/core/impl/planar_geometry.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Marks the points of a loop, or of a polyline, that have to be kept between two
 * points that are kept, so that all are within \a tolerance (Douglas and Peucker).
 * \param[in] end number of the second one; the size of a loop is its first point */
inline void
markKept(const std::vector<Eigen::Vector2d>& loop,
         std::size_t begin,
         std::size_t end,
         double tolerance,
         std::vector<std::uint8_t>& is_kept)
{
  std::vector<std::pair<std::size_t, std::size_t>> stretches{{begin, end}};
  while (!stretches.empty()) {
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    double maximum = tolerance * tolerance;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double square =
          squaredDistance(loop[i], loop[first], loop[last % loop.size()]);
      if (square > maximum) {
        maximum = square;
        farthest = i;
      }
    }
    if (farthest == first)
      continue;
    is_kept[farthest] = 1;
    stretches.emplace_back(first, farthest);
    stretches.emplace_back(farthest, last);
  }
}

} // namespace pcl::acmap
