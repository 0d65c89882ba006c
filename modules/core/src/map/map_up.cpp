#include <pcl/core/impl/up_direction.h>
#include <pcl/core/map_up.h>

#include <cmath>

namespace pcl {

namespace {

using Eigen::Vector3d;

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

/** \brief The planes with a positive area. */
std::vector<acmap::FacingArea>
facingsOf(const CompactMap& map)
{
  std::vector<acmap::FacingArea> facings;
  for (const PlanePatch& plane : map.planes) {
    const Vector3d normal = plane.coefficients.head<3>();
    if (normal.allFinite() && normal.norm() > 0 && std::isfinite(plane.area) &&
        plane.area > 0)
      facings.push_back({normal.normalized(), plane.area});
  }
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

/** \brief Area of the planes whose normals are along each axis. */
Eigen::Array3d
areasAlongAxes(const CompactMap& map)
{
  constexpr double along = 0.97; // cosine
  Eigen::Array3d areas = Eigen::Array3d::Zero();
  for (const acmap::FacingArea& facing : facingsOf(map))
    areas += facing.area * (facing.normal.array().abs() > along).cast<double>();
  return areas;
}

/** \brief z if the extent along z is smaller than along y and the area of horizontal planes
 * is larger with respect to z; otherwise -y, as in a camera frame. */
Vector3d
probableUpAxis(const CompactMap& map)
{
  const Eigen::Array3d spread = spreadOf(map), along = areasAlongAxes(map);
  return spread.z() < spread.y() && along.z() > along.y()
             ? Vector3d(Vector3d::UnitZ())
             : Vector3d(-Vector3d::UnitY());
}

} // namespace

Eigen::Vector3d
upAxis(const CompactMap& map)
{
  int axis = 0;
  if (map.up.cwiseAbs().maxCoeff(&axis) > 0)
    return std::copysign(1.0, map.up[axis]) * Vector3d::Unit(axis);
  const Vector3d cameras = upOfCameras(map.trajectory);
  if (cameras.cwiseAbs().maxCoeff(&axis) > 0)
    return std::copysign(1.0, cameras[axis]) * Vector3d::Unit(axis);
  if (map.assumed_up.cwiseAbs().maxCoeff(&axis) > 0)
    return std::copysign(1.0, map.assumed_up[axis]) * Vector3d::Unit(axis);
  return probableUpAxis(map);
}

Eigen::Vector3d
upDirection(const CompactMap& map)
{
  if (map.up.norm() > 0)
    return map.up.normalized();
  const Vector3d axis = upAxis(map);
  const Vector3d cameras = upOfCameras(map.trajectory);
  const Vector3d expected = cameras.norm() > 0.1        ? cameras.normalized()
                            : map.assumed_up.norm() > 0 ? map.assumed_up
                                                        : axis;
  const acmap::UpEstimate found =
      acmap::estimateUp(facingsOf(map), expected, acmap::up_tolerance);
  return found.share < acmap::min_up_share || acmap::isLevel(found.up, axis) ? axis
                                                                             : found.up;
}

} // namespace pcl
