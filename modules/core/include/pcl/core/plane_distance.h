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
 * Planes that the same observations saw share the errors of these poses, which then cancel.
 * With the share 1 / |A| of each observation A in its plane and the mean c of its positions,
 * \f[ \sigma^2 = \sigma_a^2 + \sigma_b^2 - 2 \left(s^2 \frac{|A \cap B|}{|A| |B|} +
 * d^2 (c_a - c)^T (c_b - c)\right) + (f \Delta)^2 \f]
 * where s, d and f are those of MapAccuracy, and the variances of the planes have their part of
 * the poses already.
 * \param[in] first, second indices in the map
 * \throws BadArgumentException when the map has no such plane, one has no polygon, or they are
 * more than 5 degrees from parallel; then the message tells the angle \ingroup core */
ACMAP_EXPORT PlaneDistance
distanceBetween(const CompactMap& map, std::size_t first, std::size_t second);

namespace acmap {

/** \brief Variance that the poses add to the offset of a plane, square metres; 0 if it is not
 * known. */
ACMAP_EXPORT double
poseVariance(const CompactMap& map, std::size_t plane);

} // namespace acmap

} // namespace pcl
