#include <pcl/core/map_up.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

using Eigen::Vector3d;

constexpr double degree = 3.14159265358979323846 / 180;

/** \brief Orientation and area of a plane, used to estimate the up direction. */
struct FacedPlane {
  Vector3d normal;
  double area;
};

/** \brief Sum of the up directions of the cameras; zero without cameras. */
Vector3d
upOfCameras(const Trajectory& trajectory)
{
  Vector3d sum = Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : trajectory.poses)
    if (pose.matrix().allFinite())
      sum -= pose.linear().col(1);
  return sum;
}

/** \brief The planes with a positive area, in descending order of area. */
std::vector<FacedPlane>
facingsOf(const CompactMap& map)
{
  std::vector<FacedPlane> facings;
  for (const PlanePatch& plane : map.planes) {
    const Vector3d normal = plane.coefficients.head<3>();
    if (normal.allFinite() && normal.norm() > 0 && std::isfinite(plane.area) &&
        plane.area > 0)
      facings.push_back({normal.normalized(), plane.area});
  }
  std::stable_sort(facings.begin(), facings.end(), [](const auto& a, const auto& b) {
    return a.area > b.area;
  });
  return facings;
}

/** \brief Variances of the corners of the planes along each axis, weighted by the areas
 * of the planes. */
Eigen::Array3d
spreadOf(const CompactMap& map)
{
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum;
  double weights = 0;
  for (const PlanePatch& plane : map.planes)
    for (const PlanePolygon& polygon : plane.polygons)
      for (const Eigen::Vector3f& corner : polygon.outer) {
        const double weight = plane.area / static_cast<double>(polygon.outer.size());
        if (!corner.allFinite() || !(weight > 0))
          continue;
        sum += weight * corner.cast<double>().array();
        squares += weight * corner.cast<double>().array().square();
        weights += weight;
      }
  if (!(weights > 0))
    return Eigen::Array3d::Zero();
  return squares / weights - (sum / weights).square();
}

/** \brief Area of the planes whose normal is along an axis. */
double
areaAlong(const std::vector<FacedPlane>& facings, int axis)
{
  constexpr double nearly = 0.97;
  double area = 0;
  for (const FacedPlane& facing : facings)
    if (std::abs(facing.normal[axis]) > nearly)
      area += facing.area;
  return area;
}

bool
isLevel(const FacedPlane& facing, const Vector3d& up)
{
  return std::abs(facing.normal.dot(up)) > std::cos(5 * degree);
}

bool
isUpright(const FacedPlane& facing, const Vector3d& up)
{
  return std::abs(facing.normal.dot(up)) < std::sin(5 * degree);
}

/** \brief Directions with respect to which the largest planes are horizontal or
 * vertical. */
std::vector<Vector3d>
candidatesFor(const std::vector<FacedPlane>& facings, const Vector3d& expected)
{
  constexpr std::size_t maximum = 30;
  const std::size_t count = std::min(facings.size(), maximum);
  std::vector<Vector3d> candidates = {expected};
  const auto add = [&](const Vector3d& direction) {
    if (direction.norm() > 0.1)
      candidates.push_back(std::copysign(1.0, direction.dot(expected)) *
                           direction.normalized());
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d& normal = facings[i].normal;
    add(normal);
    add(expected - expected.dot(normal) * normal);
    for (std::size_t k = 0; k < i; ++k)
      add(normal.cross(facings[k].normal));
  }
  return candidates;
}

/** \brief Refines an up direction by least squares, using the planes that are nearly
 * horizontal or vertical with respect to it. */
Vector3d
refined(const std::vector<FacedPlane>& facings, const Vector3d& up)
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double area = 0;
  for (const FacedPlane& facing : facings) {
    const double sign = isUpright(facing, up) ? 1 : isLevel(facing, up) ? -1 : 0;
    squares += sign * facing.area * facing.normal * facing.normal.transpose();
    area += facing.area;
  }
  constexpr double weight = 1e-3; // keeps the component that no plane determines
  squares -= weight * area * up * up.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  const Vector3d minimum = solver.eigenvectors().col(0);
  return std::copysign(1.0, minimum.dot(up)) * minimum;
}

} // namespace

Eigen::Vector3d
upAxis(const CompactMap& map)
{
  const Vector3d cameras = upOfCameras(map.trajectory);
  int axis = 0;
  if (cameras.cwiseAbs().maxCoeff(&axis) > 0)
    return std::copysign(1.0, cameras[axis]) * Vector3d::Unit(axis);
  const Eigen::Array3d spread = spreadOf(map);
  const std::vector<FacedPlane> facings = facingsOf(map);
  const bool z_is_level =
      spread.z() < spread.y() && areaAlong(facings, 2) > areaAlong(facings, 1);
  return z_is_level ? Vector3d::UnitZ() : Vector3d(-Vector3d::UnitY());
}

Eigen::Vector3d
upDirection(const CompactMap& map)
{
  constexpr double min_share = 1.0 / 3; // of the area
  const Vector3d axis = upAxis(map);
  const Vector3d cameras = upOfCameras(map.trajectory);
  const Vector3d expected = cameras.norm() > 0.1 ? cameras.normalized() : axis;
  const std::vector<FacedPlane> facings = facingsOf(map);
  double area = 0;
  for (const FacedPlane& facing : facings)
    area += facing.area;
  double best_merit = 0, best_share = 0;
  Vector3d best = axis;
  for (const Vector3d& up : candidatesFor(facings, expected)) {
    double agreeing = 0;
    for (const FacedPlane& facing : facings)
      agreeing += isLevel(facing, up) || isUpright(facing, up) ? facing.area : 0;
    const double nearness = up.dot(expected);
    const double merit = nearness < std::cos(60 * degree) ? 0 : nearness * agreeing;
    if (merit > best_merit) {
      best_merit = merit;
      best_share = agreeing / area;
      best = up;
    }
  }
  if (best_share < min_share)
    return axis;
  best = refined(facings, best);
  return best.dot(axis) > std::cos(0.5 * degree) ? axis : best;
}

} // namespace pcl
