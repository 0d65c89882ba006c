#pragma once

#include "motion_fit/pair_moments.h"

#include <pcl/egomotion/motion_fit_kernel.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Directions of a turn that the points tell less about than this part of their
 * spread (a square) are open: 1e-6 of their size is what float coordinates blur. */
constexpr double open_part = 1e-12;

/** \brief The rotation about the centroids that minimises Eq. 2, at once: by an angle
 * in the plane (Planar) or by singular values (Rigid, never a reflection). */
Eigen::Quaterniond
closedFormRotation(const PairMoments& moments, MotionModel model);

/** \brief What \ref descend found: a motion about the centroids. */
struct Descent {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< in units of the moments' scale
  std::size_t iterations = 0;
  bool has_converged = false;
};

/** \brief Minimises Eq. 2 by conjugate gradient, from where the source stands. */
Descent
descend(const PairMoments& moments, MotionModel model);

} // namespace pcl::acmap
