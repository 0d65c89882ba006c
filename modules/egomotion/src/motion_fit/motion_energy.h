#pragma once

#include "motion_fit/rotation_fit.h"

#include <Eigen/Core>

#include <optional>

namespace pcl::acmap {

/** \brief An offset (in units of the moments' scale) and a turn (rotation vector,
 * radians), both in the target's frame, the turn after the rotation so far. */
using MotionStep = Eigen::Matrix<double, 6, 1>;

/** \brief Eq. 2 about the centroids, which is |offset|^2 - 2 tr (R^T cross) and what
 * does not change. */
class MotionEnergy {
public:
  MotionEnergy(const PairMoments& moments, MotionModel model);

  /** \brief Half of the gradient. */
  MotionStep
  gradient(const Descent& at) const;

  /** \brief The gradient by the points' inertia about each axis: a step of the right
   * size, none about an axis that the points lie on. */
  MotionStep
  preconditioned(const Descent& at, const MotionStep& gradient) const;

  /** \brief How far along a step the energy is least; it must lead down. */
  double
  lowest(const Descent& at, const MotionStep& step) const;

  /** \brief An axis about which any turn leads down, though the gradient is nought:
   * after half a turn, say. */
  std::optional<Eigen::Vector3d>
  ridge(const Descent& at) const;

private:
  Eigen::Matrix3d
  turnedCross(const Descent& at) const;

  const PairMoments& moments_;
  Eigen::Matrix3d axes_;    ///< of inertia, those open set to 0, source's frame
  Eigen::Vector3d inertia_; ///< about them, 1 where open
  bool is_planar_;
};

} // namespace pcl::acmap
