#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/up_direction.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;

constexpr double degree = 3.14159265358979323846 / 180;

bool
isHorizontal(const FacingArea& facing, const Vector3d& up, double tolerance)
{
  return std::abs(facing.normal.dot(up)) > std::cos(tolerance);
}

bool
isUpright(const FacingArea& facing, const Vector3d& up, double tolerance)
{
  return std::abs(facing.normal.dot(up)) < std::sin(tolerance);
}

/** The direction nearest to \a up whose sum of signed squared cosines is minimal. */
Vector3d
minimumOf(Eigen::Matrix3d squares, const Vector3d& up, double area)
{
  constexpr double weight = 1e-3; // keeps the component that no plane determines
  squares -= weight * area * up * up.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  const Vector3d minimum = solver.eigenvectors().col(0);
  return std::copysign(1.0, minimum.dot(up)) * minimum;
}

/** \brief Directions with respect to which the largest planes are horizontal or
 * vertical. */
std::vector<Vector3d>
candidatesFor(const std::vector<FacingArea>& facings, const Vector3d& expected)
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
refined(const std::vector<FacingArea>& facings, const Vector3d& up, double tolerance)
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double area = 0;
  for (const FacingArea& facing : facings) {
    const double sign = isUpright(facing, up, tolerance)      ? 1
                        : isHorizontal(facing, up, tolerance) ? -1
                                                              : 0;
    squares += sign * facing.area * facing.normal * facing.normal.transpose();
    area += facing.area;
  }
  return minimumOf(squares, up, area);
}

double
tukey(double deviation, double tolerance)
{
  const double ratio = deviation / tolerance;
  return ratio < 1 ? std::pow(1 - ratio * ratio, 2) : 0;
}

} // namespace

UpEstimate
estimateUp(std::vector<FacingArea> facings, const Vector3d& expected, double tolerance)
{
  std::stable_sort(facings.begin(), facings.end(), [](const auto& a, const auto& b) {
    return a.area > b.area;
  });
  double area = 0;
  for (const FacingArea& facing : facings)
    area += facing.area;
  double best_merit = 0;
  UpEstimate best{expected};
  for (const Vector3d& up : candidatesFor(facings, expected)) {
    double agreeing = 0;
    for (const FacingArea& facing : facings)
      agreeing +=
          isHorizontal(facing, up, tolerance) || isUpright(facing, up, tolerance)
              ? facing.area
              : 0;
    const double nearness = up.dot(expected);
    const double merit = nearness < std::cos(60 * degree) ? 0 : nearness * agreeing;
    if (merit > best_merit) {
      best_merit = merit;
      best = {up, agreeing / area};
    }
  }
  if (best.share >= min_up_share)
    best.up = refined(facings, best.up, tolerance);
  return best;
}

Vector3d
refineUp(const std::vector<FacingArea>& facings, const Vector3d& up, double tolerance)
{
  constexpr int rounds = 10;
  Vector3d found = up;
  for (int round = 0; round < rounds; ++round) {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double area = 0;
    for (const FacingArea& facing : facings) {
      const double cosine = std::min(1.0, std::abs(facing.normal.dot(found)));
      const double weight =
          tukey(std::asin(cosine), tolerance) - tukey(std::acos(cosine), tolerance);
      squares += weight * facing.area * facing.normal * facing.normal.transpose();
      area += facing.area;
    }
    found = minimumOf(squares, found, area);
  }
  return found;
}

bool
isLevel(const Vector3d& up, const Vector3d& axis)
{
  return up.dot(axis) > std::cos(0.5 * degree);
}

std::optional<Vector3d>
upWithoutSensors(const CloudRows& cloud,
                 const UpEvidence& up,
                 bool has_sensor,
                 bool sensors_fit)
{
  if (findField(cloud.layout(), "view", PCLPointField::INT32))
    return std::nullopt;
  if (has_sensor ? sensors_fit : !up.isKnown() && sensors_fit)
    return std::nullopt;
  return up.value;
}

} // namespace pcl::acmap
