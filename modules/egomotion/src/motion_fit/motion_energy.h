#pragma once

#include "motion_fit/rotation_fit.h"

#include <Eigen/Core>

#include <optional>

namespace pcl::acmap {

/** \brief An offset (in units of the moments' scale) and a rotation (rotation vector,
 * radians), both in the target's frame; the rotation is applied after the current one.
 */
using MotionStep = Eigen::Matrix<double, 6, 1>;

/** \brief Eq. 2 about the centroids: |offset|^2 - 2 tr (R^T cross) and a constant. */
class MotionEnergy {
public:
  MotionEnergy(const PairMoments& moments, MotionModel model);

  /** \brief Half of the gradient. */
  MotionStep
  gradient(const Descent& at) const;

  /** \brief The gradient divided by the inertia of the points about each axis, which is
   * a step of suitable size; it has no rotation about a line that contains all points.
   */
  MotionStep
  preconditioned(const Descent& at, const MotionStep& gradient) const;

  /** \brief Step length at which the energy is minimal; the step must be a descent
   * direction. */
  double
  lowest(const Descent& at, const MotionStep& step) const;

  /** \brief At a stationary point that is not a minimum, for example after half a
   * rotation: an axis about which any rotation decreases the energy. */
  std::optional<Eigen::Vector3d>
  ridge(const Descent& at) const;

private:
  Eigen::Matrix3d
  turnedCross(const Descent& at) const;

  const PairMoments& moments_;
  Eigen::Matrix3d axes_;    ///< axes of inertia, source's frame, 0 if undetermined
  Eigen::Vector3d inertia_; ///< about these axes, 1 if undetermined
  bool is_planar_;
};

} // namespace pcl::acmap
