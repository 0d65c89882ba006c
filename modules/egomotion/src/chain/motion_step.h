#pragma once

#include "chain/normal_equations.h"

#include <pcl/egomotion/impl/motion_fit_kernel.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief The small motions that a model allows, one per column. */
Eigen::Matrix<double, 6, Eigen::Dynamic>
motionBasis(MotionModel model);

/** \brief Solves the equations for the small motion; undetermined directions are 0. */
Vector6
solvedStep(const NormalEquations& equations, MotionModel model);

/** \brief Covariance of the small motion, 0 outside of the model. If any direction of
 * the model is undetermined, the whole diagonal within the model is infinite. */
Matrix6
covarianceOf(const NormalEquations& equations, MotionModel model);

/** \brief The same for residuals whose errors are correlated within groups: the
 * sandwich estimator H^-1 S H^-1, in addition to H^-1.
 * \param[in] scatter S, the covariance of the gradient by the groups */
Matrix6
covarianceOf(const NormalEquations& equations,
             const Matrix6& scatter,
             MotionModel model);

/** \brief Applies a small motion, in the frame to which the pose maps, to a pose. */
Eigen::Isometry3d
afterStep(const Vector6& step, const Eigen::Isometry3d& pose);

} // namespace pcl::acmap
