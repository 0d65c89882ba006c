#include "map_observations.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double steepest = 0.7071; // cosine of 45 degrees
constexpr double alike = 0.9962;    // cosine of 5 degrees
// minimum fraction of the points that are on floors
constexpr double min_share = 0.02;
constexpr std::size_t max_tried = 300;

/** Normals of possible floors or ceilings, flipped to y > 0. */
std::vector<Eigen::Vector3f>
floorNormals(const MapObservations& observations, std::size_t& points)
{
  std::vector<Eigen::Vector3f> normals;
  for (std::size_t i = 0; i < observations.clouds.size(); ++i) {
    const Eigen::Matrix3f rotation =
        observations.trajectory.poses[i].linear().cast<float>();
    points += observations.clouds[i]->size();
    for (const PointNormal& point : *observations.clouds[i]) {
      const Eigen::Vector3f normal = rotation * point.getNormalVector3fMap();
      if (std::abs(normal.y()) > steepest)
        normals.emplace_back(normal.y() > 0 ? normal : Eigen::Vector3f(-normal));
    }
  }
  return normals;
}

/** Number and sum of the normals similar to this one. */
std::pair<std::size_t, Eigen::Vector3f>
gather(const std::vector<Eigen::Vector3f>& normals, const Eigen::Vector3f& like)
{
  std::pair<std::size_t, Eigen::Vector3f> found(0, Eigen::Vector3f::Zero());
  for (const Eigen::Vector3f& normal : normals)
    if (normal.dot(like) > alike) {
      ++found.first;
      found.second += normal;
    }
  return found;
}

} // namespace

std::optional<Eigen::Vector3d>
floorNormalOf(const MapObservations& observations)
{
  std::size_t points = 0;
  const std::vector<Eigen::Vector3f> normals = floorNormals(observations, points);
  const std::size_t step = 1 + normals.size() / max_tried;
  std::pair<std::size_t, Eigen::Vector3f> best(0, Eigen::Vector3f::UnitY());
  for (std::size_t i = 0; i < normals.size(); i += step) {
    const auto found = gather(normals, normals[i]);
    if (found.first > best.first)
      best = found;
  }
  if (static_cast<double>(best.first) < min_share * static_cast<double>(points) ||
      best.first == 0)
    return std::nullopt;
  return best.second.cast<double>().normalized();
}

} // namespace pcl::acmap
