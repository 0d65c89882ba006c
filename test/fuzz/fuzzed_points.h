#pragma once

#include "fuzzed_bytes.h"

#include <pcl/core/impl/point_view.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::acmap::test {

/** \brief How bytes are converted to points: on a lattice, so that duplicate,
 * collinear, coplanar and cocircular points are frequent. */
struct PointStyle {
  float scale = 1;          ///< metres per step
  float far = 0;            ///< metres, added to each coordinate
  std::uint8_t steps = 255; ///< bit mask for the byte of a coordinate
  bool is_fine = false;     ///< two bytes per coordinate
  bool is_flat = false;     ///< z is 0
  bool has_odd = false;     ///< some bytes mean NaN, infinite, huge, denormal

  explicit PointStyle(FuzzedBytes& bytes);

  /** \brief Are coordinates neither too large nor too small for squares in float? */
  bool
  isModerate() const;

  float
  coordinate(FuzzedBytes& bytes) const;

  Eigen::Vector3f
  point(FuzzedBytes& bytes) const;
};

/** \brief Points of one style, until the end of the bytes or \a maximum points. */
std::vector<Eigen::Vector3f>
fuzzedPoints(FuzzedBytes& bytes, const PointStyle& style, std::size_t maximum);

/** \brief Unit normal, or NaN for zero bytes. */
Eigen::Vector3f
fuzzedNormal(FuzzedBytes& bytes);

PointView
viewOf(const std::vector<Eigen::Vector3f>& points);

/** \brief Indices of the points that are finite and no duplicates of earlier ones. */
std::vector<std::int32_t>
usablePoints(const std::vector<Eigen::Vector3f>& points);

} // namespace pcl::acmap::test
