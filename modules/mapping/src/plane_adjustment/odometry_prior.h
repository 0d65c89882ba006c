#pragma once

#include "measured_motion.h"

#include <pcl/mapping/impl/plane_adjustment_kernel.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Applies a small motion in the frame of the camera: rotation vector, then
 * translation. */
Eigen::Isometry3d
retract(const Eigen::Isometry3d& pose, const Vector6& motion);

/** \brief What the odometry says about consecutive poses: residuals of the actions,
 * weighted by their inverse covariances. The first pose is fixed. */
class OdometryPrior {
public:
  OdometryPrior(const Poses& given, const PlaneAdjustmentSettings& settings);

  std::size_t
  actions() const
  {
    return actions_.size();
  }

  /** \brief Sum of the squared residuals in standard deviations. */
  double
  cost(const Poses& poses) const;

  /** \brief Adds to the normal equations; pose i is row i - 1.
   * \param[in,out] gradient one per row */
  void
  linearize(const Poses& poses,
            PoseSystem& system,
            std::vector<Vector6>& gradient) const;

  /** \brief Rescales the standard deviations of rotations and translations so that the
   * residuals agree with them, considering how far the planes determine the actions
   * (MacKay's evidence update).
   * \param[in] covariance of the actions under the planes and the prior */
  void
  rescale(const Poses& poses, const std::vector<Matrix6>& covariance);

  /** \brief Factors on the standard deviations of rotations and translations. */
  const Eigen::Vector2d&
  factors() const
  {
    return factors_;
  }

  /** \brief Share of an action's six degrees of freedom, from 0 to 6, that the odometry
   * determines and the planes do not.
   * \param[in] covariance of the action under both */
  double
  shareOf(std::size_t action, const Matrix6& covariance) const
  {
    return (information_[action] * covariance).trace();
  }

  /** \brief Covariances of the actions that follow from those of the poses.
   * \param[in] inverse of the equations */
  std::vector<Matrix6>
  covariances(const Poses& poses, const PoseSystem& inverse) const;

private:
  struct Action {
    MeasuredMotion motion;
    Matrix6 covariance;
  };

  void
  updateInformation();

  std::vector<Action> actions_;
  std::vector<Matrix6> information_;
  Eigen::Vector2d factors_ = Eigen::Vector2d::Ones();
};

} // namespace pcl::acmap
