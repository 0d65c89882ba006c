#include "odometry_prior.h"

#include "../odometry_sigmas.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/rotation_vector.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

Matrix6
covarianceOf(const OdometryNoise& noise, const Eigen::Isometry3d& motion)
{
  const double turn = turnSigma(noise, Eigen::AngleAxisd(motion.linear()).angle());
  const double length = lengthSigma(noise, motion.translation().norm());
  Vector6 variances;
  variances.head<3>().setConstant(turn * turn);
  variances.tail<3>().setConstant(length * length);
  return variances.asDiagonal();
}

} // namespace

void
requireOdometryNoise(const OdometryNoise& noise)
{
  requireInRange("odometry noise, length", noise.length, 1e-6, 1e3, "m");
  requireInRange(
      "odometry noise, length a metre", noise.length_per_metre, 0, 10, "m/m");
  requireInRange("odometry noise, turn", noise.turn, 1e-6, 10, "rad");
  requireInRange(
      "odometry noise, turn a radian", noise.turn_per_radian, 0, 10, "rad/rad");
}

void
requireActionCovariance(const ActionCovariance& covariance)
{
  constexpr double tolerance = 1e-9;
  const bool is_finite = covariance.allFinite();
  if (!is_finite ||
      (covariance - covariance.transpose()).cwiseAbs().maxCoeff() >
          tolerance * covariance.cwiseAbs().maxCoeff() ||
      covariance.llt().info() != Eigen::Success)
    throw acmap::BadArgument("the covariance of an action must be symmetric and "
                             "positive definite, in rad^2 and m^2");
}

Eigen::Isometry3d
retract(const Eigen::Isometry3d& pose, const Vector6& motion)
{
  Eigen::Isometry3d result = pose;
  const Eigen::AngleAxisd turn = rotationOf(motion.head<3>());
  if (turn.angle() > 0) {
    const Eigen::Quaterniond rotation(Eigen::Quaterniond(pose.linear()) *
                                      Eigen::Quaterniond(turn));
    result.linear() = rotation.normalized().toRotationMatrix();
  }
  result.translation() = pose.translation() + pose.linear() * motion.tail<3>();
  return result;
}

OdometryPrior::OdometryPrior(const Poses& given,
                             const PlaneAdjustmentSettings& settings)
{
  const auto& covariances = settings.action_covariances;
  for (std::size_t i = 0; i + 1 < given.size(); ++i) {
    const Eigen::Isometry3d motion = given[i].inverse() * given[i + 1];
    actions_.push_back({{i, i + 1, motion},
                        covariances.empty() ? covarianceOf(settings.odometry, motion)
                                            : covariances[i]});
  }
  updateInformation();
}

void
OdometryPrior::updateInformation()
{
  information_.clear();
  Vector6 scale;
  scale.head<3>().setConstant(1 / factors_[0]);
  scale.tail<3>().setConstant(1 / factors_[1]);
  for (const Action& action : actions_)
    information_.push_back(scale.asDiagonal() *
                           action.covariance.llt().solve(Matrix6::Identity()).eval() *
                           scale.asDiagonal());
}

double
OdometryPrior::cost(const Poses& poses) const
{
  double cost = 0;
  for (std::size_t i = 0; i < actions_.size(); ++i)
    cost += actions_[i].motion.cost(poses, information_[i]);
  return cost;
}

std::vector<Matrix6>
OdometryPrior::covariances(const Poses& poses, const PoseSystem& inverse) const
{
  std::vector<Matrix6> covariances;
  for (const Action& action : actions_)
    covariances.push_back(action.motion.covariance(poses, inverse));
  return covariances;
}

void
OdometryPrior::linearize(const Poses& poses,
                         PoseSystem& system,
                         std::vector<Vector6>& gradient) const
{
  for (std::size_t i = 0; i < actions_.size(); ++i)
    actions_[i].motion.linearize(poses, information_[i], system, gradient);
}

void
OdometryPrior::rescale(const Poses& poses, const std::vector<Matrix6>& covariance)
{
  constexpr double smallest = 0.05, largest = 10;
  Eigen::Vector2d squares = Eigen::Vector2d::Zero(), free = squares;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const Vector6 r = actions_[i].motion.residual(poses);
    for (int k = 0; k < 6; ++k) {
      const double factor = factors_[k / 3];
      const double variance = factor * factor * actions_[i].covariance(k, k);
      squares[k / 3] += r[k] * r[k] / variance;
      free[k / 3] += std::max(0.0, 1 - covariance[i](k, k) / variance);
    }
  }
  for (int k = 0; k < 2; ++k)
    if (free[k] > 10)
      factors_[k] =
          std::clamp(factors_[k] * std::sqrt(squares[k] / free[k]), smallest, largest);
  updateInformation();
}

} // namespace pcl::acmap
