#pragma once

#include "point_tree.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Tells the side of a surface from which it can have been measured, if no sensor is
 * known but the up direction.
 *
 * Rays from the surface end at other surfaces. Floors and ceilings face the larger of two
 * gaps that end at a surface, otherwise the one that ends; where neither ends, as on a
 * ground surveyed from the air, they face up. Walls face the side where a floor or ground
 * begins at them; if there is one on both sides or on none, they face the larger gap. */
class FreeSpace {
public:
  /** \param[in] normals of the points of the tree, with any sign; zero where the surface is
   * not flat
   * \param[in] up unit vector */
  FreeSpace(const PointTree& tree,
            const LargeVector<Eigen::Vector3f>& normals,
            const Eigen::Vector3d& up);

  /** \brief Side of a surface at a point of the tree.
   * \param[in] normal unit vector
   * \param[in] reach a ray ends where a point is nearer than this, metres
   * \return 1: that of the normal, -1: the other one, 0: unknown */
  int
  sideOf(std::int32_t point, const Eigen::Vector3d& normal, double reach) const;

private:
  struct Ray;
  struct End;

  End
  endOf(const Ray& ray) const;

  End
  nearestTo(const Eigen::Vector3d& place, const Ray& ray) const;

  bool
  endsAtFloor(const Ray& ray) const;

  int
  sideOfWall(std::int32_t point, const Eigen::Vector3d& level, double reach) const;

  const PointTree& tree_;
  const LargeVector<Eigen::Vector3f>& normals_;
  Eigen::Vector3d up_;
  Eigen::AlignedBox3d box_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
