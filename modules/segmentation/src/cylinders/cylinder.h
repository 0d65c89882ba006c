#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::acmap::cylinders {

/** An infinite cylinder in the frame of the elements. */
struct Cylinder {
  Eigen::Vector3d point = Eigen::Vector3d::Zero(); ///< on the axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< unit
  double radius = 0;                               ///< metres, above 0
  bool is_hollow = false;                          ///< seen from inside

  /** From the axis to a place, perpendicular to the axis. */
  Eigen::Vector3d
  across(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d from = place - point;
    return from - from.dot(axis) * axis;
  }

  double
  along(const Eigen::Vector3d& place) const
  {
    return (place - point).dot(axis);
  }

  /** Signed distance of a place from the surface, metres; negative inside. */
  double
  distance(const Eigen::Vector3d& place) const
  {
    return across(place).norm() - radius;
  }
};

/** A measured point, and the unit direction from its sensor, zero if unknown. */
struct Sample {
  Eigen::Vector3d point;
  Eigen::Vector3d ray = Eigen::Vector3d::Zero();

  bool
  hasRay() const
  {
    return ray.x() != 0 || ray.y() != 0 || ray.z() != 0;
  }
};

/** How far a sample is from a cylinder: along its ray, or otherwise along the normal. */
struct Offset {
  bool exists = false; ///< false for rays that pass the cylinder
  double value = 0;    ///< metres, measured minus expected
  double slant = 1;    ///< cosine between ray and outward normal; 1 without a ray
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< outward, at the foot
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();   ///< on the surface

  /** A convex cylinder is seen at the first intersection of the ray, a hollow one at
   * the second: at grazing rays the nearer of both would be the wrong one. */
  Offset(const Cylinder& cylinder, const Sample& sample)
  {
    const Eigen::Vector3d from = cylinder.across(sample.point);
    if (!sample.hasRay()) {
      const double radius = from.norm();
      exists = radius > 0;
      if (!exists)
        return;
      normal = from / radius;
      value = radius - cylinder.radius;
      foot = sample.point - value * normal;
      return;
    }
    const Eigen::Vector3d way =
        sample.ray - sample.ray.dot(cylinder.axis) * cylinder.axis;
    const double a = way.squaredNorm();
    const double b = from.dot(way);
    const double rest = b * b - a * (from.squaredNorm() - std::pow(cylinder.radius, 2));
    exists = a > 1e-12 && rest > 0;
    if (!exists)
      return;
    const double root = std::sqrt(rest);
    const double further = (-b + (cylinder.is_hollow ? root : -root)) / a;
    value = -further;
    normal = (from + further * way) / cylinder.radius;
    foot = sample.point + further * sample.ray;
    slant = normal.dot(sample.ray);
  }
};

/** Angles about the axis and positions along it: the developed surface. */
struct Development {
  Eigen::Vector3d u; ///< direction of angle 0
  Eigen::Vector3d v;

  explicit Development(const Cylinder& cylinder)
  : u(cylinder.axis.unitOrthogonal())
  , v(cylinder.axis.cross(u))
  {}

  double
  angle(const Eigen::Vector3d& normal) const
  {
    return std::atan2(normal.dot(v), normal.dot(u));
  }
};

/** At most about \a maximum of some values, evenly chosen. */
template <typename T>
std::vector<T>
thinned(const std::vector<T>& values, std::size_t maximum)
{
  const std::size_t step = values.size() / maximum + 1;
  std::vector<T> chosen;
  for (std::size_t i = 0; i < values.size(); i += step)
    chosen.push_back(values[i]);
  return chosen;
}

} // namespace pcl::acmap::cylinders
