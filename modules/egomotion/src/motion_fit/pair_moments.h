#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief All that Eq. 2 needs to know about the pairs, weights summing up to 1.
 * Lengths are told in units of `scale`, so that no square can overflow. */
struct PairMoments {
  double scale = 0;               ///< metres; 0: no pair that counts
  Eigen::Vector3d source, target; ///< centroids, metres
  Eigen::Matrix3d spread;         ///< sum w a a^T, a = source - centroid
  double target_spread = 0;       ///< sum w b^T b, b = target - centroid
  Eigen::Matrix3d cross;          ///< sum w b a^T
};

/** \brief Whether a pair and its squares are finite, and it is of some weight. */
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

/** \brief Of the pairs that count. */
PairMoments
pairMoments(const std::vector<Eigen::Vector3d>& source,
            const std::vector<Eigen::Vector3d>& target,
            const std::vector<double>& weights);

} // namespace pcl::acmap
