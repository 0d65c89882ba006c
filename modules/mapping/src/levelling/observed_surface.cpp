#include "facing_table.h"

#include <pcl/mapping/impl/levelling_kernel.h>

#include <cmath>

namespace pcl::acmap {

ObservedSurface
observedSurface(const PointView& points,
                const PointView& normals,
                const std::vector<float>& weights)
{
  constexpr double front = 0.42; // cosine of 65 degrees
  ObservedSurface seen;
  seen.points = points.size();
  FacingTable facings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point = points[i].cast<double>();
    if (!point.allFinite()) {
      ++seen.invalid_points;
      continue;
    }
    const double weight = weights.empty() ? 1 : weights[i];
    seen.weight += weight;
    seen.in_front += point.z() > front * point.norm() ? weight : 0;
    seen.sum += weight * point;
    seen.squares += weight * point * point.transpose();
    if (normals.size() > 0)
      facings.add(normals[i].cast<double>(), weight);
  }
  seen.facings = facings.facings();
  return seen;
}

} // namespace pcl::acmap
