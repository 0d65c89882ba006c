#pragma once

#include "planes/known_planes.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::test {

/** \brief Boards of points with their planes, as passed on by the region growing. */
class KnownBoards {
public:
  explicit KnownBoards(double spacing)
  {
    known_.spacing = spacing;
  }

  /** \brief Adds a board with its own plane: corner + i u + j v, metres; n = u x v. */
  void
  add(const Eigen::Vector3d& corner,
      const Eigen::Vector3d& u,
      int columns,
      const Eigen::Vector3d& v,
      int rows)
  {
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        points_.emplace_back((corner + i * u + j * v).cast<float>());
        known_.labels.push_back(static_cast<std::int32_t>(known_.planes.size()));
      }
    KnownPlane plane;
    PlanePatch& patch = plane.patch;
    const Eigen::Vector3d normal = u.cross(v).normalized();
    patch.center = corner + (columns - 1) / 2.0 * u + (rows - 1) / 2.0 * v;
    patch.coefficients << normal, -normal.dot(patch.center);
    patch.axis_u = normal.unitOrthogonal();
    patch.axis_v = normal.cross(patch.axis_u);
    patch.area = columns * u.norm() * rows * v.norm();
    known_.planes.push_back(plane);
  }

  /** \brief The planes; their points are stored in this object. */
  KnownPlanes
  known() const
  {
    KnownPlanes result = known_;
    result.points = points();
    return result;
  }

  PointView
  points() const
  {
    return {points_.data(), sizeof(Eigen::Vector3f), points_.size()};
  }

private:
  std::vector<Eigen::Vector3f> points_;
  KnownPlanes known_;
};

} // namespace pcl::acmap::test
