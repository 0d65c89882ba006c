#pragma once

#include <pcl/core/trinocular_rig.h>
#include <pcl/simulation/scene_geometry.h>

#include <cmath>
#include <optional>
#include <variant>

namespace pcl::acmap {

/** \brief Range of valid depths, metres; nearer surfaces touch the lens. */
struct DepthRange {
  double minimum = 1e-3;
  double maximum = 0;

  bool
  contains(double depth) const // false for NaN
  {
    return depth >= minimum && depth <= maximum;
  }
};

/** \brief Rectangle in the camera frame. The ray direction d has z = 1, therefore the
 * factor of a hit is its depth: depth = offset / (normal d), u = (u_axis d) / (normal
 * d). */
struct RectangleTarget {
  Eigen::Vector3d normal, u_axis, v_axis;
  double offset;
  double u_slack, v_slack; ///< tolerance of u and v, avoids gaps at common edges

  double
  depth(const Eigen::Vector3d& d, const DepthRange&) const
  {
    const double cosine = normal.dot(d);
    const double u = u_axis.dot(d) / cosine;
    const double v = v_axis.dot(d) / cosine;
    const bool inside =
        u >= -u_slack && u <= 1.0 + u_slack && v >= -v_slack && v <= 1.0 + v_slack;
    return inside ? offset / cosine : -1.0;
  }
};

/** \brief Disc in the camera frame. */
struct DiscTarget {
  Eigen::Vector3d normal, center;
  double radius;

  double
  depth(const Eigen::Vector3d& d, const DepthRange&) const
  {
    const double depth = normal.dot(center) / normal.dot(d);
    return (depth * d - center).squaredNorm() <= radius * radius ? depth : -1.0;
  }
};

/** \brief Curved side of a cylinder in the camera frame. */
struct CylinderTarget {
  Eigen::Vector3d base, axis; ///< axis of unit length
  double length, radius;

  double
  depth(const Eigen::Vector3d& d, const DepthRange& range) const
  {
    const Eigen::Vector3d across = d - axis.dot(d) * axis;
    const Eigen::Vector3d to_axis = base - axis.dot(base) * axis;
    const double a = across.squaredNorm();
    const double b = across.dot(to_axis);
    const double c = to_axis.squaredNorm() - radius * radius;
    const double root = std::sqrt(b * b - a * c); // NaN if the ray misses the cylinder
    for (const double depth : {(b - root) / a, (b + root) / a}) {
      const double along = axis.dot(depth * d - base);
      if (range.contains(depth) && along >= 0.0 && along <= length)
        return depth;
    }
    return -1.0;
  }
};

/** \brief Pixels from first to last, both included. */
struct PixelBox {
  int first_column, last_column;
  int first_row, last_row;
};

/** \brief A surface that may be visible in a view. */
struct CastTarget {
  std::int32_t surface;
  PixelBox box;
  std::variant<RectangleTarget, CylinderTarget, DiscTarget> shape;
};

/** \brief Transforms a surface to the camera frame.
 * \return nothing when no pixel can see it */
std::optional<CastTarget>
targetOf(const SimulatedSurface& surface,
         std::int32_t index,
         const TrinocularRig& rig,
         const Eigen::Isometry3d& T_camera_scene,
         const DepthRange& range);

} // namespace pcl::acmap
