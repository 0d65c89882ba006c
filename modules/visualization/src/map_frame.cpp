#include "map_camera.h"

#include <pcl/core/map_up.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;

/** \brief Dominant horizontal direction of the walls, assuming mostly right angles; an
 * arbitrary one if there are no walls. */
Vector3d
wallDirection(const CompactMap& map, const Vector3d& up)
{
  const Vector3d e = up.unitOrthogonal(), f = up.cross(e);
  // four times an angle is equal for directions that differ by 90 degrees
  std::complex<double> sum;
  for (const PlanePatch& plane : map.planes) {
    const Vector3d normal = plane.coefficients.head<3>();
    const std::complex<double> level(normal.dot(e), normal.dot(f));
    if (std::abs(level) > 0.9 && std::isfinite(plane.area))
      sum += plane.area * std::polar(1.0, 4 * std::arg(level));
  }
  const double angle = std::abs(sum) > 0 ? std::arg(sum) / 4 : 0;
  return std::cos(angle) * e + std::sin(angle) * f;
}

double
extentAlong(const std::vector<Eigen::Vector3f>& samples, const Vector3d& direction)
{
  double minimum = INFINITY, maximum = -INFINITY;
  for (const Eigen::Vector3f& sample : samples) {
    const double place = sample.cast<double>().dot(direction);
    minimum = std::min(minimum, place);
    maximum = std::max(maximum, place);
  }
  return maximum - minimum;
}

/** \brief Flips a direction so that its largest component is positive. */
Vector3d
forwards(const Vector3d& direction)
{
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return direction[axis] < 0 ? Vector3d(-direction) : direction;
}

} // namespace

MapFrame
frameOf(const CompactMap& map,
        const std::vector<Eigen::Vector3f>& samples,
        const SceneView& view)
{
  MapFrame frame;
  frame.up =
      view.up ? Vector3d(view.up->cast<double>().normalized()) : upDirection(map);
  const Vector3d one = wallDirection(map, frame.up);
  const Vector3d other = frame.up.cross(one);
  frame.along =
      forwards(extentAlong(samples, one) >= extentAlong(samples, other) ? one : other);
  return frame;
}

} // namespace pcl::acmap
