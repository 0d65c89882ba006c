#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The moments of the pairs that Eq. 2 depends on; the weights have the sum 1.
 * Lengths are in units of `scale`, so that no square can overflow. */
struct PairMoments {
  double scale = 0;               ///< metres; 0: no valid pair
  Eigen::Vector3d source, target; ///< centroids, metres
  Eigen::Matrix3d spread;         ///< sum w a a^T, a = source - centroid
  double target_spread = 0;       ///< sum w b^T b, b = target - centroid
  Eigen::Matrix3d cross;          ///< sum w b a^T
};

/** \brief Returns true if a pair and its squares are finite and its weight is positive.
 */
bool
doesCount(const std::vector<Eigen::Vector3d>& source,
          const std::vector<Eigen::Vector3d>& target,
          const std::vector<double>& weights,
          std::size_t pair);

inline double
weightOf(const std::vector<double>& weights, std::size_t pair)
{
  return weights.empty() ? 1.0 : weights[pair];
}

/** \brief Moments of the valid pairs. */
PairMoments
pairMoments(const std::vector<Eigen::Vector3d>& source,
            const std::vector<Eigen::Vector3d>& target,
            const std::vector<double>& weights);

} // namespace pcl::acmap
