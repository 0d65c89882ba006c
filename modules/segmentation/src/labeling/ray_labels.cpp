#include "labeling/ray_labels.h"

#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/parallel.h>

namespace pcl::acmap::labeling {

PointLabels
RayLabels::chooseAll(const Survey& survey) const
{
  PointLabels labels;
  assignLarge(labels, survey.size(), std::int32_t{-1});
  parallelForChunks(survey.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (survey.entry(i) >= 0)
        labels[i] = choose(survey.sight(i), grid_[survey.entry(i)]);
  });
  return labels;
}

/** Does the ray intersect the plane on that side of the other planes on which the plane
 * lies? */
bool
RayLabels::isInFront(const Eigen::Vector3d& foot,
                     std::size_t own,
                     const Candidates& candidates) const
{
  for (std::size_t k = 0; k < candidates.size; ++k) {
    const auto other = static_cast<std::size_t>(candidates.planes[k]);
    const int side = other == own ? 0 : junctions_.side(own, other);
    if (side == 0)
      continue;
    const Eigen::Vector4d& its = planes_[other].patch.coefficients;
    if (side * (its.head<3>().dot(foot) + its[3]) < 0)
      return false;
  }
  return true;
}

std::int32_t
RayLabels::choose(const Sight& sight, const Candidates& candidates) const
{
  constexpr double max_sigmas = 4.5;
  double minimum = max_sigmas * max_sigmas, min_seen = minimum;
  std::int32_t nearest = -1, seen = -1;
  for (std::size_t k = 0; k < candidates.size; ++k) {
    const auto plane = static_cast<std::size_t>(candidates.planes[k]);
    const Crossing crossing(sight, planes_[plane].patch);
    const double square =
        crossing.off * crossing.off / noise_.variance(crossing, planes_[plane]);
    if (square < minimum) {
      minimum = square;
      nearest = candidates.planes[k];
    }
    if (square < min_seen && candidates.size > 1 &&
        isInFront(crossing.foot, plane, candidates)) {
      min_seen = square;
      seen = candidates.planes[k];
    }
  }
  return seen >= 0 ? seen : nearest;
}

} // namespace pcl::acmap::labeling
