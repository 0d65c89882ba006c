#pragma once

#include "chain/normal_equations.h"

#include <pcl/core/pinhole.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

/** \brief Squared width of Cauchy's cost, in standard deviations: residuals far beyond
 * three have little weight. */
constexpr double cauchy_width = 9;

/** \brief Weight of a squared residual (in standard deviations) in Cauchy's cost. */
inline double
robustWeight(double squared)
{
  return 1 / (1 + squared / cauchy_width);
}

/** \brief Parts of an image whose residuals have independent errors: 4 by 4 tiles. */
constexpr std::size_t tiles_along = 4, tile_count = tiles_along * tiles_along;

/** \brief The tile of the ray to a point, in the frame of a camera whose image is
 * centred; z > 0. */
inline std::size_t
tileOf(const Pinhole& pinhole, const Eigen::Vector3d& point)
{
  const Eigen::Vector2d pixel = pinhole.project(point);
  const auto along = [](double place, double center) {
    const double tile = std::floor(place / (2 * center) * tiles_along);
    return static_cast<std::size_t>(std::clamp(tile, 0.0, tiles_along - 1.0));
  };
  return along(pixel.y(), pinhole.cy) * tiles_along + along(pixel.x(), pinhole.cx);
}

/** \brief Normal equations of one kind of residuals, and how well they fit. */
struct Evidence {
  NormalEquations equations;
  std::array<Vector6, tile_count> gradients; ///< of the equations, by tile
  double cost = 0;                           ///< sum of Cauchy's costs
  double squares = 0;    ///< weighted sum of squared residuals, in standard deviations
  double weights = 0;    ///< sum of the weights of \ref squares
  std::size_t count = 0; ///< number of residuals

  Evidence()
  {
    gradients.fill(Vector6::Zero());
  }

  /** \brief Adds a residual to the equations. */
  void
  add(std::size_t tile, const Vector6& row, double residual, double weight)
  {
    equations.add(row, residual, weight);
    gradients[tile] += weight * residual * row;
  }

  /** \brief Adds the cost of a residual.
   * \param[in] squared squared residual, in standard deviations
   * \param[in] numbers dimension of the residual */
  void
  tell(double squared, int numbers = 1)
  {
    const double weight = robustWeight(squared);
    cost += cauchy_width / 2 * std::log1p(squared / cauchy_width);
    squares += weight * squared / numbers;
    weights += weight;
    ++count;
  }

  void
  add(const Evidence& other)
  {
    equations.add(other.equations);
    for (std::size_t tile = 0; tile < tile_count; ++tile)
      gradients[tile] += other.gradients[tile];
    cost += other.cost;
    squares += other.squares;
    weights += other.weights;
    count += other.count;
  }

  double
  meanCost() const
  {
    return count > 0 ? cost / static_cast<double>(count) : 0;
  }

  /** \brief Ratio of the mean squared residual to its expectation; at least 1. */
  double
  excess() const
  {
    return weights > 0 ? std::max(squares / weights, 1.0) : 1;
  }
};

} // namespace pcl::acmap
