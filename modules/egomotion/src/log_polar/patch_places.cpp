#include "patch_places.h"

#include <cmath>

namespace pcl::acmap {

PatchPlaces
placesOf(const LogPolarPatches& patches,
         const std::vector<Eigen::Vector3f>& points,
         const MatchGate& gate,
         float distance_per_metre)
{
  PatchPlaces places;
  for (const std::int32_t pixel : patches.pixels) {
    places.u.push_back(static_cast<float>(pixel % patches.width));
    places.v.push_back(static_cast<float>(pixel / patches.width));
  }
  if (!std::isfinite(gate.distance))
    return places;
  for (const std::int32_t keypoint : patches.keypoint) {
    const Eigen::Vector3f& point = points[static_cast<std::size_t>(keypoint)];
    places.x.push_back(point.x());
    places.y.push_back(point.y());
    places.z.push_back(point.z());
    places.reach.push_back(gate.distance / 2 + distance_per_metre * point.norm());
  }
  return places;
}

void
applyGate(const PatchPlaces& rows,
          std::size_t row,
          const PatchPlaces& columns,
          const MatchGate& gate,
          std::int32_t* scores)
{
  const std::size_t size = columns.u.size();
  if (std::isfinite(gate.image_distance)) {
    const float maximum = gate.image_distance * gate.image_distance;
    const float u = rows.u[row], v = rows.v[row];
    for (std::size_t j = 0; j < size; ++j) {
      const float right = columns.u[j] - u, down = columns.v[j] - v;
      scores[j] = right * right + down * down <= maximum ? scores[j] : no_score;
    }
  }
  if (std::isfinite(gate.distance)) {
    const float x = rows.x[row], y = rows.y[row], z = rows.z[row];
    const float reach = rows.reach[row];
    for (std::size_t j = 0; j < size; ++j) {
      const float a = columns.x[j] - x, b = columns.y[j] - y, c = columns.z[j] - z;
      const float maximum = reach + columns.reach[j];
      // The comparison is false if a point is NaN.
      scores[j] = a * a + b * b + c * c <= maximum * maximum ? scores[j] : no_score;
    }
  }
}

} // namespace pcl::acmap
