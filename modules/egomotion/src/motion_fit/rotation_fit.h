#pragma once

#include "motion_fit/pair_moments.h"

#include <pcl/egomotion/impl/motion_fit_kernel.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief A rotation is undetermined if its information is below this part of the
 * squared spread of the points, because float coordinates have errors of up to 1e-6 of
 * the size. */
constexpr double open_part = 1e-12;

/** \brief The rotation about the centroids that minimises Eq. 2, in closed form: an
 * angle in the plane (Planar) or from singular values (Rigid, never a reflection). */
Eigen::Quaterniond
closedFormRotation(const PairMoments& moments, MotionModel model);

/** \brief Result of \ref descend, a motion about the centroids. */
struct Descent {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< in units of the moments' scale
  std::size_t iterations = 0;
  bool has_converged = false;
};

/** \brief Minimises Eq. 2 by conjugate gradient, starting from the identity rotation.
 */
Descent
descend(const PairMoments& moments, MotionModel model);

} // namespace pcl::acmap
