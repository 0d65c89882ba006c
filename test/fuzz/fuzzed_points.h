#pragma once

#include "fuzzed_bytes.h"

#include <pcl/core/point_view.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::acmap::test {

/** \brief How points are made of bytes: on a lattice, so that doubled, collinear, coplanar
 * and cocircular ones are common. */
struct PointStyle {
  float scale = 1;          ///< metres a step
  float far = 0;            ///< metres, added to every coordinate
  std::uint8_t steps = 255; ///< a coordinate's byte is cut to these bits
  bool is_fine = false;     ///< two bytes a coordinate
  bool is_flat = false;     ///< z is 0
  bool has_odd = false;     ///< some bytes mean NaN, infinite, huge, denormal

  explicit PointStyle(FuzzedBytes& bytes);

  /** \brief Neither so large nor so small that squares leave the floats. */
  bool
  isModerate() const;

  float
  coordinate(FuzzedBytes& bytes) const;

  Eigen::Vector3f
  point(FuzzedBytes& bytes) const;
};

/** \brief Points of one style, until the bytes or \a most are at an end. */
std::vector<Eigen::Vector3f>
fuzzedPoints(FuzzedBytes& bytes, const PointStyle& style, std::size_t most);

/** \brief Unit, or NaN where the bytes say nothing. */
Eigen::Vector3f
fuzzedNormal(FuzzedBytes& bytes);

PointView
viewOf(const std::vector<Eigen::Vector3f>& points);

/** \brief Those that are finite and at a place of their own, each once. */
std::vector<std::int32_t>
usablePoints(const std::vector<Eigen::Vector3f>& points);

} // namespace pcl::acmap::test
