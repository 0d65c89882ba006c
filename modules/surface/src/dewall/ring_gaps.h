#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/impl/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief How far apart the rings of a scanner with several beams are on a surface. Along a ring
 * the points are much closer, so that the nearest neighbours do not show it. */
class RingGaps {
public:
  /** \param[in] scan all points of which the sensor measured, in rows of equal elevation about
   * an axis of the frame; without such rows, no gap is known
   * \param[in] sensor its position */
  RingGaps(const PointView& scan, const Eigen::Vector3d& sensor);

  /** \brief Distance between the ring at a place of the surface and the nearer one of those above
   * and below, metres; 0 if none is on the same surface, as far as can be told. */
  double
  at(const Eigen::Vector3d& place) const;

private:
  /** A point of the scan as it is seen from the sensor. */
  struct Sight {
    double elevation, turn; ///< radians, above the plane across the axis, and about it
    Eigen::Vector3d ray;
  };

  /** Points of equal elevation, in the order of their turns. */
  struct Ring {
    double elevation = 0; ///< mean
    std::vector<Sight> sights;
  };

  Sight
  sightOf(const Eigen::Vector3d& ray) const;

  void
  findRings(const PointView& scan);

  static const Sight&
  nearestOf(const Ring& ring, double turn);

  double
  distanceTo(const Ring& ring, const Sight& sight, double step) const;

  Eigen::Vector3d sensor_;
  int axis_ = 2;
  std::vector<Ring> rings_; ///< by elevation; none: they are not known
};

} // namespace pcl::acmap::ACMAP_DEWALL
