#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <Eigen/Core>

#include <cstddef>

namespace pcl {

/** \brief Distance between two parallel planes of a map, metres. \ingroup core */
struct PlaneDistance {
  double distance = 0;
  Eigen::Vector3d place =
      Eigen::Vector3d::Zero(); ///< where it was measured, on the first plane

  /** \brief Standard deviation of the distance; NaN if a plane has no covariance. */
  double deviation = 0;

  /** \brief The deviation is that of independent noise alone, since the accuracy of the poses is
   * not known, as for a single cloud: the distance may be worse. */
  bool is_at_least = false;
};

/** \brief Measures the distance between two planes at the middle of their overlap: of the
 * rectangles around both, along the axes of the first; between their centres if they do not
 * overlap.
 *
 * Its variance is that of both planes there, less what they have in common by the poses
 * (PlanePatch::pose_modes): planes that were seen from the same places are known better with respect
 * to each other than in the map. The scale of the sensor is not included.
 * \param[in] first, second indices in the map
 * \throws BadArgumentException when the map has no such plane, one has no polygon, or they are
 * more than 5 degrees from parallel; then the message tells the angle \ingroup core */
ACMAP_EXPORT PlaneDistance
distanceBetween(const CompactMap& map, std::size_t first, std::size_t second);

} // namespace pcl
