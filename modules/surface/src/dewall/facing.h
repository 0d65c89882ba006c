#pragma once

#include "point_tree.h"

#include <pcl/core/point_view.h>

#include <array>
#include <vector>

namespace pcl::acmap::dewall {

/** \brief The side from which each point was seen, where that is known: a direction off
 * the surface. Where it is, the mesh is oriented by it from its first triangle on, and no
 * component ever has to be turned over. */
class Facing {
public:
  /** \brief Nothing is known. */
  Facing() = default;

  /** \brief One sensor saw all points. */
  static Facing
  towards(const PointTree& tree, const Eigen::Vector3d& sensor);

  /** \brief By normals, those of the array whose points the tree holds. Unknown when
   * fewer than half of them are of unit length, or when neighbours disagree. */
  static Facing
  byNormals(const PointTree& tree, const PointView& normals);

  bool
  isKnown() const
  {
    return !directions_.empty();
  }

  /** \brief Twice the area that a triangle shows to that side, negative when it shows
   * its back; 0 where nothing is known. */
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

  std::vector<Eigen::Vector3f>
      directions_; // unit, or zero where one point's is unknown
};

} // namespace pcl::acmap::dewall
