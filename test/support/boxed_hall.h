#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace pcl::acmap::test {

/** \brief A box that is seen from inside, with boxes in it. */
struct BoxedHall {
  Eigen::AlignedBox3d walls;
  std::vector<Eigen::AlignedBox3d> things;

  /** \brief Where a ray of length 1, no component of which is 0, ends. */
  double
  range(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const
  {
    double nearest = 1e9;
    for (int axis = 0; axis < 3; ++axis)
      nearest = std::min(
          nearest,
          ((ray[axis] > 0 ? walls.max() : walls.min())[axis] - eye[axis]) / ray[axis]);
    for (const Eigen::AlignedBox3d& thing : things) {
      double enters = 0, leaves = nearest;
      for (int axis = 0; axis < 3; ++axis) {
        const double a = (thing.min()[axis] - eye[axis]) / ray[axis];
        const double b = (thing.max()[axis] - eye[axis]) / ray[axis];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
      }
      if (enters < leaves)
        nearest = std::min(nearest, enters);
    }
    return nearest;
  }
};

} // namespace pcl::acmap::test
