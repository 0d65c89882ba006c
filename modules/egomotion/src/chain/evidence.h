#pragma once

#include "chain/normal_equations.h"

#include <algorithm>
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

/** \brief Normal equations of one kind of residuals, and how well they fit. */
struct Evidence {
  NormalEquations equations;
  double cost = 0;       ///< sum of Cauchy's costs
  double squares = 0;    ///< weighted sum of squared residuals, in standard deviations
  double weights = 0;    ///< sum of the weights of \ref squares
  std::size_t count = 0; ///< number of residuals

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
