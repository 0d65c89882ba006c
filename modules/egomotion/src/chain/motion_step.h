#pragma once

#include "chain/normal_equations.h"

#include <pcl/egomotion/motion_fit_kernel.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief The small motions that a model allows, one a column. */
Eigen::Matrix<double, 6, Eigen::Dynamic>
motionBasis(MotionModel model);

/** \brief The small motion that the equations ask for; directions of which they tell
 * nothing stay 0. */
Vector6
solvedStep(const NormalEquations& equations, MotionModel model);

/** \brief Covariance of the small motion, 0 outside of the model; infinite where the
 * equations leave something open. */
Matrix6
covarianceOf(const NormalEquations& equations, MotionModel model);

/** \brief A pose after a small motion in the frame it leads to. */
Eigen::Isometry3d
afterStep(const Vector6& step, const Eigen::Isometry3d& pose);

} // namespace pcl::acmap
