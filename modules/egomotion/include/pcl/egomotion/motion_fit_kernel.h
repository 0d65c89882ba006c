#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief How a camera may move. \ingroup egomotion */
enum class MotionModel {
  Planar, ///< in the XZ plane and about y: the paper's action, 3 degrees of freedom
  Rigid   ///< freely, 6 degrees of freedom
};

/** \brief How Eq. 2 is minimised. \ingroup egomotion */
enum class MotionSolver {
  ConjugateGradient, ///< as the paper
  ClosedForm         ///< at once
};

namespace acmap {

/** \brief What \ref fitMotion found. */
struct MotionFit {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  double energy = 0;          ///< Eq. 2, weighted, m^2
  std::size_t iterations = 0; ///< of the conjugate gradient
  bool has_converged = true;
};

/** \brief The motion that minimises Eq. 2, sum w_i |target_i - T source_i|^2. Where the
 * points leave directions open (none, one, or on a line) these stay as they are. Time O(n):
 * an iteration needs the pairs' moments alone.
 * \param[in] source, target as many points, metres; pairs that are not finite do not count
 * \param[in] weights one a pair, >= 0; empty: 1 */
ACMAP_EXPORT MotionFit
fitMotion(const std::vector<Eigen::Vector3d>& source,
          const std::vector<Eigen::Vector3d>& target,
          const std::vector<double>& weights,
          MotionModel model,
          MotionSolver solver);

} // namespace acmap
} // namespace pcl
