#include "planes/plane_sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl::acmap::planes {

namespace {

/** How the sensors of the points of a plane are to it. */
struct Sightings {
  std::size_t in_front = 0, behind = 0;
  std::size_t along =
      0; ///< the plane is seen along itself, from less than a degree off
};

std::vector<Sightings>
sightingsOf(const PointView& points,
            const SensorView& sensors,
            const PointLabels& labels,
            const std::vector<KnownPlane>& planes)
{
  constexpr double grazing = 0.02;
  std::vector<Sightings> sightings(planes.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Eigen::Vector3f* const sensor = labels[i] < 0 ? nullptr : sensors[i];
    if (!sensor)
      continue;
    const auto plane = static_cast<std::size_t>(labels[i]);
    const Eigen::Vector4d& equation = planes[plane].patch.coefficients;
    const Eigen::Vector3d origin = sensor->cast<double>();
    const double height = equation.head<3>().dot(origin) + equation[3];
    const double range = (points[i].cast<double>() - origin).norm();
    Sightings& seen = sightings[plane];
    ++(height < 0 ? seen.behind : seen.in_front);
    seen.along += std::abs(height) < grazing * range;
  }
  return sightings;
}

/** Reverses the normal; the frame stays right-handed. */
void
turn(PlanePatch& patch)
{
  patch.coefficients = -patch.coefficients;
  patch.axis_v = -patch.axis_v;
  const Eigen::Vector3d signs(-1, 1, -1); // slope along u, along v, offset
  patch.covariance = signs.asDiagonal() * patch.covariance * signs.asDiagonal();
}

void
renumber(const std::vector<std::int32_t>& numbers, PointLabels& labels)
{
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = numbers[static_cast<std::size_t>(label)];
}

} // namespace

PlaneSides
turnToSensors(const PointView& points,
              const SensorView& sensors,
              PointLabels& labels,
              KnownPlanes& known)
{
  PlaneSides result;
  if (!sensors.isKnown())
    return result;
  const std::vector<Sightings> sightings =
      sightingsOf(points, sensors, labels, known.planes);
  std::vector<std::int32_t> numbers;
  std::vector<KnownPlane> kept;
  for (std::size_t p = 0; p < known.planes.size(); ++p) {
    const Sightings& seen = sightings[p];
    if (2 * seen.along > seen.in_front + seen.behind) {
      ++result.removed;
      numbers.push_back(-1);
      continue;
    }
    numbers.push_back(static_cast<std::int32_t>(kept.size()));
    kept.push_back(std::move(known.planes[p]));
    if (seen.behind > seen.in_front) {
      turn(kept.back().patch);
      ++result.turned;
    }
  }
  known.planes = std::move(kept);
  if (result.removed > 0) {
    renumber(numbers, labels);
    renumber(numbers, known.labels);
  }
  return result;
}

} // namespace pcl::acmap::planes
