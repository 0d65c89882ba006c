#pragma once

#include <pcl/simulation/scene_geometry.h>

namespace pcl::acmap {

/** \brief Unit normal of a surface at a point on it, to either side; in the scene's
 * frame. */
inline Eigen::Vector3d
surfaceNormal(const SimulatedSurface& surface, const Eigen::Vector3d& point)
{
  struct NormalAt {
    const Eigen::Vector3d& point;

    Eigen::Vector3d
    operator()(const SimulatedRectangle& rectangle) const
    {
      return rectangle.normal();
    }

    Eigen::Vector3d
    operator()(const SimulatedDisc& disc) const
    {
      return disc.normal;
    }

    Eigen::Vector3d
    operator()(const SimulatedCylinder& cylinder) const
    {
      const Eigen::Vector3d from_base = point - cylinder.base;
      const Eigen::Vector3d along =
          cylinder.axis * (from_base.dot(cylinder.axis) / cylinder.axis.squaredNorm());
      return (from_base - along).normalized();
    }
  };
  return std::visit(NormalAt{point}, surface.shape);
}

} // namespace pcl::acmap
