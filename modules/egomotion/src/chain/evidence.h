#pragma once

#include "chain/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

/** \brief Of Cauchy's cost, squared, in standard deviations: what is far beyond three
 * counts little. */
constexpr double cauchy_width = 9;

/** \brief Cauchy's weight of a squared residual in standard deviations. */
inline double
robustWeight(double squared)
{
  return 1 / (1 + squared / cauchy_width);
}

/** \brief What one kind of observation tells about a motion, and how well it fits. */
struct Evidence {
  NormalEquations equations;
  double cost = 0;       ///< sum of Cauchy's costs
  double squares = 0;    ///< weighted sum of squared residuals, in standard deviations
  double weights = 0;    ///< of these
  std::size_t count = 0; ///< residuals

  /** \brief Adds a residual's fit.
   * \param[in] numbers that it consists of */
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

  /** \brief By how much residuals exceed what was expected of them, squared; at least
   * 1. */
  double
  excess() const
  {
    return weights > 0 ? std::max(squares / weights, 1.0) : 1;
  }
};

} // namespace pcl::acmap
