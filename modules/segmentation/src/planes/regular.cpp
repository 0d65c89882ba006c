#include "planes/known_planes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap::planes {
namespace {

constexpr double deviations = 3;
constexpr double min_turn = 1e-4;   // radians; for covariances that are too small
constexpr double max_turn = 0.0175; // one degree

double
allowedTurn(const PlanePatch& patch)
{
  const double tilt =
      std::sqrt(patch.covariance.diagonal().head<2>().maxCoeff()); // NaN: unknown
  return std::isfinite(tilt) ? std::clamp(deviations * tilt, min_turn, max_turn)
                             : max_turn;
}

double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** Returns the nearest normal that is parallel to a direction, or otherwise
 * perpendicular to those that are nearly perpendicular to it. The total rotation is at
 * most \a turn. */
Eigen::Vector3d
regularNormal(const Eigen::Vector3d& normal,
              const std::vector<Eigen::Vector3d>& directions,
              double turn)
{
  for (const Eigen::Vector3d& direction : directions)
    if (normal.cross(direction).norm() < std::sin(turn))
      return normal.dot(direction) < 0 ? Eigen::Vector3d(-direction) : direction;
  Eigen::Vector3d turned = normal;
  std::vector<Eigen::Vector3d> upright; // orthogonal to each other
  for (const Eigen::Vector3d& direction : directions) {
    if (upright.size() == 2 || std::abs(normal.dot(direction)) > std::sin(turn))
      continue;
    Eigen::Vector3d rest = direction;
    for (const Eigen::Vector3d& other : upright)
      rest -= rest.dot(other) * other;
    constexpr double of_its_own = 0.1;
    if (rest.norm() < of_its_own)
      continue;
    rest.normalize();
    const Eigen::Vector3d further = (turned - turned.dot(rest) * rest).normalized();
    if (angleBetween(normal, further) > turn)
      continue;
    upright.push_back(rest);
    turned = further;
  }
  return turned;
}

void
turnTo(const Eigen::Vector3d& normal, PlanePatch& patch)
{
  patch.axis_u = (patch.axis_u - patch.axis_u.dot(normal) * normal).normalized();
  patch.axis_v = normal.cross(patch.axis_u);
  patch.coefficients << normal, -normal.dot(patch.center);
}

} // namespace

Regularity
makeRegular(std::vector<KnownPlane>& planes)
{
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return planes[a].patch.area > planes[b].patch.area;
  });
  Regularity regularity;
  std::vector<Eigen::Vector3d> directions;
  for (const std::size_t p : order) {
    PlanePatch& patch = planes[p].patch;
    const Eigen::Vector3d before = patch.coefficients.head<3>();
    const Eigen::Vector3d after = regularNormal(before, directions, allowedTurn(patch));
    const double turn = angleBetween(before, after);
    constexpr double rounding = 1e-9;
    if (turn > rounding) {
      turnTo(after, patch);
      ++regularity.turned;
      regularity.largest_turn = std::max(regularity.largest_turn, turn);
    }
    directions.push_back(patch.coefficients.head<3>());
  }
  return regularity;
}

} // namespace pcl::acmap::planes
