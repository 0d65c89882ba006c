#pragma once

#include "point_tree.h"

#include <pcl/core/impl/point_view.h>

#include <array>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief The normal, or zero if its length is not 1. */
Eigen::Vector3f
usableNormal(const Eigen::Vector3f& normal);

/** \brief Area of a triangle projected towards the sensor; negative if its back faces
 * the sensor. */
double
areaFacing(const PointTree& tree,
           const std::array<std::int32_t, 3>& corners,
           const Eigen::Vector3d& sensor);

/** \brief For each point, the direction towards the side from which it was measured, if
 * known. If it is known, the mesh is oriented by it from the first triangle on, and no
 * component ever has to be flipped. */
class Facing {
public:
  /** \brief The directions are unknown. */
  Facing() = default;

  /** \brief The directions from all points to one sensor. */
  static Facing
  towards(const PointTree& tree, const Eigen::Vector3d& sensor);

  /** \brief The directions of the normals of the array from which the points of the
   * tree are. They are unknown if fewer than half of the normals have unit length, or
   * if neighbours disagree. */
  static Facing
  byNormals(const PointTree& tree, const PointView& normals);

  /** \brief The given directions, a unit vector or zero for each point of the tree. */
  static Facing
  along(LargeVector<Eigen::Vector3f> directions)
  {
    Facing facing;
    facing.directions_ = std::move(directions);
    return facing;
  }

  bool
  isKnown() const
  {
    return !directions_.empty();
  }

  /** \brief Twice the area of a triangle projected along the direction, negative if its
   * back side is visible; 0 if unknown. */
  double
  shownArea(const PointTree& tree, const std::array<std::int32_t, 3>& corners) const
  {
    if (directions_.empty())
      return 0;
    const Eigen::Vector3d a = tree.position(corners[0]), b = tree.position(corners[1]),
                          c = tree.position(corners[2]);
    const Eigen::Vector3f side =
        direction(corners[0]) + direction(corners[1]) + direction(corners[2]);
    return (b - a).cross(c - a).dot(side.cast<double>()) / 3;
  }

private:
  const Eigen::Vector3f&
  direction(std::int32_t i) const
  {
    return directions_[static_cast<std::size_t>(i)];
  }

  /** Unit, or zero for points whose direction is unknown. */
  LargeVector<Eigen::Vector3f> directions_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
