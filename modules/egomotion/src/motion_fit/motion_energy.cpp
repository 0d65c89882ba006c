#include "motion_fit/motion_energy.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl::acmap {

namespace {

Eigen::Vector3d
torqueOf(const Eigen::Matrix3d& turned)
{
  return {turned(2, 1) - turned(1, 2),
          turned(0, 2) - turned(2, 0),
          turned(1, 0) - turned(0, 1)};
}

/** Half of the derivative of the energy along a step, as a function of the step length.
 */
struct Slope {
  double offset = 0, offset_growth = 0; ///< offset . step, step . step
  double turn = 0;                      ///< radians per unit of the step length
  double cosine = 0, sine = 0;          ///< coefficients of tr (R^T cross)

  double
  at(double way) const
  {
    const double angle = way * turn;
    return offset + way * offset_growth +
           turn * (cosine * std::sin(angle) - sine * std::cos(angle));
  }

  double
  growthAt(double way) const
  {
    const double angle = way * turn;
    return offset_growth +
           turn * turn * (cosine * std::cos(angle) + sine * std::sin(angle));
  }
};

/** Newton's method within a bracket. */
double
rootOf(const Slope& slope)
{
  double low = 0, high = 1;
  for (int doubling = 0; doubling < 64 && slope.at(high) < 0; ++doubling) {
    low = high;
    high *= 2;
  }
  double way = high;
  for (int round = 0; round < 60; ++round) {
    const double value = slope.at(way);
    (value < 0 ? low : high) = way;
    double next = way - value / slope.growthAt(way);
    if (!(next > low && next < high))
      next = (low + high) / 2;
    if (std::abs(next - way) <= 1e-15 * way)
      break;
    way = next;
  }
  return way;
}

} // namespace

MotionEnergy::MotionEnergy(const PairMoments& moments, MotionModel model)
: moments_(moments)
, is_planar_(model == MotionModel::Planar)
{
  const Eigen::Matrix3d& spread = moments.spread;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      spread.trace() * Eigen::Matrix3d::Identity() - spread);
  axes_ = solver.eigenvectors();
  inertia_ = solver.eigenvalues();
  if (is_planar_) {
    axes_.setIdentity();
    inertia_ = Eigen::Vector3d(0, spread(0, 0) + spread(2, 2), 0);
  }
  const double open = open_part * spread.trace();
  for (int axis = 0; axis < 3; ++axis)
    if (inertia_[axis] <= open) {
      axes_.col(axis).setZero();
      inertia_[axis] = 1;
    }
}

Eigen::Matrix3d
MotionEnergy::turnedCross(const Descent& at) const
{
  return moments_.cross * at.rotation.toRotationMatrix().transpose();
}

MotionStep
MotionEnergy::gradient(const Descent& at) const
{
  MotionStep gradient;
  gradient.head<3>() = at.offset;
  gradient.tail<3>() = -torqueOf(turnedCross(at));
  return gradient;
}

MotionStep
MotionEnergy::preconditioned(const Descent& at, const MotionStep& gradient) const
{
  const Eigen::Matrix3d axes = at.rotation.toRotationMatrix() * axes_;
  MotionStep step = gradient;
  const Eigen::Vector3d turn = axes.transpose() * gradient.tail<3>();
  step.tail<3>() = axes * turn.cwiseQuotient(inertia_);
  return step;
}

double
MotionEnergy::lowest(const Descent& at, const MotionStep& step) const
{
  Slope slope;
  slope.offset = at.offset.dot(step.head<3>());
  slope.offset_growth = step.head<3>().squaredNorm();
  slope.turn = step.tail<3>().norm();
  if (slope.turn > 0) {
    const Eigen::Matrix3d turned = turnedCross(at);
    const Eigen::Vector3d axis = step.tail<3>() / slope.turn;
    slope.cosine = turned.trace() - axis.dot(turned * axis);
    slope.sine = axis.dot(torqueOf(turned));
  }
  return rootOf(slope);
}

std::optional<Eigen::Vector3d>
MotionEnergy::ridge(const Descent& at) const
{
  const Eigen::Matrix3d turned = turnedCross(at);
  const Eigen::Matrix3d axes = at.rotation.toRotationMatrix() * axes_;
  const Eigen::Matrix3d curvature =
      turned.trace() * Eigen::Matrix3d::Identity() - (turned + turned.transpose()) / 2;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(axes.transpose() *
                                                              curvature * axes);
  if (solver.eigenvalues()[0] >=
      -open_part * std::sqrt(moments_.spread.trace() * moments_.target_spread))
    return std::nullopt;
  return (axes * solver.eigenvectors().col(0)).normalized();
}

} // namespace pcl::acmap
