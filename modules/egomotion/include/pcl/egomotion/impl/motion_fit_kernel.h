#pragma once

#include <pcl/core/export.h>
#include <pcl/egomotion/egomotion_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl {

namespace acmap {

/** \brief Result of \ref fitMotion. */
struct MotionFit {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  double energy = 0;          ///< Eq. 2, weighted, m^2
  std::size_t iterations = 0; ///< of the conjugate gradient method
  bool has_converged = true;
};

/** \brief Finds the motion that minimises Eq. 2, sum w_i |target_i - T source_i|^2.
 * Directions that the points do not determine (no points, one point, or points on a
 * line) remain unchanged. Time O(n), because an iteration only uses the moments of the
 * pairs.
 * \param[in] source, target equally many points, metres; pairs that are not finite are
 * ignored
 * \param[in] weights one per pair, >= 0; if empty, all are 1 */
ACMAP_EXPORT MotionFit
fitMotion(const std::vector<Eigen::Vector3d>& source,
          const std::vector<Eigen::Vector3d>& target,
          const std::vector<double>& weights,
          MotionModel model,
          MotionSolver solver);

} // namespace acmap
} // namespace pcl
