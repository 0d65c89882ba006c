#include "camera_fit.h"

#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;

constexpr double margin = 1.1;

/** Points farther away than this many half box sizes are outliers that need not be
 * visible. */
constexpr double stray_factor = 3.0;

/** Fraction of the other points that may be cut off at each border. */
constexpr double cut_share = 0.0005;

/** Iterations of centring and fitting; each changes the perspective a little. */
constexpr int rounds = 4;

/** \brief Quantile of values; reorders them. */
template <typename Number>
Number
quantile(std::vector<Number>& values, double share)
{
  const auto last = static_cast<double>(values.size() - 1);
  return valueOfRank(values, static_cast<std::size_t>(std::lround(share * last)));
}

/** \brief Points without outliers in the axes of the camera (right, up, towards the
 * eye), relative to the focus. */
std::vector<Vector3d>
seenPoints(const Camera& camera,
           const Vector3d& direction,
           const std::vector<Eigen::Vector3f>& points,
           const RobustBox& box)
{
  const Vector3d right = direction.cross(camera.up);
  std::vector<Vector3d> seen;
  for (const Eigen::Vector3f& point : points) {
    const Vector3d d = point.cast<double>() - camera.focus;
    if (box.contains(point.cast<double>(), stray_factor))
      seen.emplace_back(d.dot(right), d.dot(camera.up), -d.dot(direction));
  }
  return seen;
}

/** \brief Minimum distance of the eye from the focus at which the points fit. */
double
fittingDistance(const std::vector<Vector3d>& seen,
                const Vector3d& offset,
                double slope_x,
                double slope_y)
{
  std::vector<double> distances;
  for (const Vector3d& p : seen)
    distances.push_back(p.z() + std::max(std::abs(p.x() - offset.x()) / slope_x,
                                         std::abs(p.y() - offset.y()) / slope_y));
  return quantile(distances, 1 - 2 * cut_share) * margin;
}

/** \brief Centre of the projected points, as an offset of the focus. */
double
middleOffset(const std::vector<Vector3d>& seen,
             int axis,
             double offset,
             double distance)
{
  std::vector<double> slopes;
  for (const Vector3d& p : seen)
    if (p.z() < distance)
      slopes.push_back((p[axis] - offset) / (distance - p.z()));
  if (slopes.empty())
    return offset;
  const double minimum = quantile(slopes, cut_share);
  const double maximum = quantile(slopes, 1 - cut_share);
  return offset + (minimum + maximum) / 2 * distance;
}

} // namespace

RobustBox::RobustBox(const std::vector<Eigen::Vector3f>& points)
{
  constexpr double outside = 0.02;
  std::vector<float> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(points.begin(), points.end(), values.begin(), [&](const auto& p) {
      return p[axis];
    });
    const double minimum = quantile(values, outside);
    const double maximum = quantile(values, 1 - outside);
    middle[axis] = (minimum + maximum) / 2;
    half[axis] = (maximum - minimum) / 2;
  }
}

bool
RobustBox::contains(const Vector3d& point, double factor) const
{
  // the box of a flat scene has no depth
  const double slack = 0.1 * half.maxCoeff() + 1e-9;
  return ((point - middle).cwiseAbs().array() <= half.array() * factor + slack).all();
}

void
fitCamera(Camera& camera,
          const Vector3d& direction,
          const std::vector<Eigen::Vector3f>& points,
          const RobustBox& box,
          double aspect,
          bool center)
{
  const double slope_y = std::tan(camera.view_angle / 2 * M_PI / 180.0);
  const double slope_x = slope_y * aspect;
  const std::vector<Vector3d> seen = seenPoints(camera, direction, points, box);
  // a single point fits any distance
  double distance = std::max(1e-3, 1e-3 * camera.focus.norm());
  Vector3d offset = Vector3d::Zero();
  for (int round = 0; round < rounds && !seen.empty(); ++round) {
    distance = std::max(distance, fittingDistance(seen, offset, slope_x, slope_y));
    for (int axis = 0; center && axis < 2; ++axis)
      offset[axis] = middleOffset(seen, axis, offset[axis], distance);
    distance =
        std::max(1e-3 * distance, fittingDistance(seen, offset, slope_x, slope_y));
  }
  camera.focus += offset.x() * direction.cross(camera.up) + offset.y() * camera.up;
  camera.position = camera.focus - direction * distance;
}

void
setDepths(Camera& camera,
          const std::vector<Eigen::Vector3f>& points,
          const RobustBox& box)
{
  const Vector3d ahead = camera.focus - camera.position;
  double minimum = ahead.norm(), maximum = minimum;
  for (const Eigen::Vector3f& point : points) {
    const Vector3d p = point.cast<double>();
    if (!box.contains(p, stray_factor))
      continue;
    const double depth = (p - camera.position).dot(ahead.normalized());
    minimum = std::min(minimum, depth);
    maximum = std::max(maximum, depth);
  }
  camera.far = maximum * 1.05;
  camera.near = std::max(minimum * 0.95, camera.far * 1e-3);
}

} // namespace pcl::acmap
