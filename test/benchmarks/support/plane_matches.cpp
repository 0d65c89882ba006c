#include "plane_matches.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

MatchDeviation
deviationOf(const Eigen::Vector4d& found,
            const Eigen::Vector4d& truth,
            const Eigen::Vector3d& centroid)
{
  const Eigen::Vector3d normal = truth.head<3>();
  const Eigen::Vector3d place = centroid - (normal.dot(centroid) + truth[3]) * normal;
  const Eigen::Vector3d found_normal = found.head<3>();
  const double sine = normal.cross(found_normal).norm();
  return {std::atan2(sine, std::abs(normal.dot(found_normal))) * 180 / M_PI,
          std::abs(found_normal.dot(place) + found[3])};
}

std::vector<Eigen::Vector3d>
centroidsOf(const PlaneCase& plane_case, const PlaneOverlaps& overlaps)
{
  const PlaneTruth& truth = plane_case.truth;
  std::vector<Eigen::Vector3d> centroids(truth.planes.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < truth.labels.size(); ++i)
    if (truth.labels[i] >= 0)
      centroids[static_cast<std::size_t>(truth.labels[i])] +=
          (*plane_case.input.points)[i].getVector3fMap().cast<double>();
  for (std::size_t t = 0; t < centroids.size(); ++t)
    centroids[t] /=
        static_cast<double>(std::max<std::size_t>(overlaps.truthSize(t), 1));
  return centroids;
}

} // namespace

PlaneMatches
matchPlanes(const PlaneCase& plane_case,
            const FoundPlanes& found,
            const PlaneOverlaps& overlaps,
            const MatchLimits& limits)
{
  const std::vector<TruthPlane>& planes = plane_case.truth.planes;
  const std::vector<Eigen::Vector3d> centroids = centroidsOf(plane_case, overlaps);
  PlaneMatches matches;
  matches.finder.assign(planes.size(), -1);
  matches.deviation.resize(planes.size());
  for (std::size_t f = 0; f < found.planes.size(); ++f) {
    const auto t = static_cast<std::size_t>(std::max(overlaps.majority(f), 0));
    const MatchDeviation deviation =
        deviationOf(found.planes[f], planes[t].coefficients, centroids[t]);
    const bool is_of_truth =
        2 * overlaps.common(f, t) >= std::max<std::size_t>(overlaps.foundSize(f), 1);
    if (!is_of_truth || deviation.angle > limits.angle ||
        deviation.offset > limits.offset) {
      ++matches.spurious;
      matches.astray += is_of_truth;
      continue;
    }
    std::int32_t& finder = matches.finder[t];
    matches.duplicates += finder >= 0;
    if (finder < 0 ||
        overlaps.common(f, t) > overlaps.common(static_cast<std::size_t>(finder), t)) {
      finder = static_cast<std::int32_t>(f);
      matches.deviation[t] = deviation;
    }
  }
  return matches;
}

} // namespace pcl::acmap::bench
