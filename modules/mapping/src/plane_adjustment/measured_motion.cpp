#include "measured_motion.h"

namespace pcl::acmap {
namespace {

Eigen::Matrix3d
crossMatrix(const Eigen::Vector3d& v)
{
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

Eigen::Vector3d
rotationVector(const Eigen::Matrix3d& rotation)
{
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

} // namespace

Vector6
MeasuredMotion::residual(const Poses& poses) const
{
  const Eigen::Isometry3d motion = poses[earlier].inverse() * poses[later];
  Vector6 residual;
  residual << rotationVector(T_earlier_later.linear().transpose() * motion.linear()),
      motion.translation() - T_earlier_later.translation();
  return residual;
}

MeasuredMotion::Jacobians
MeasuredMotion::jacobians(const Poses& poses) const
{
  const Eigen::Isometry3d motion = poses[earlier].inverse() * poses[later];
  const Eigen::Vector3d error =
      rotationVector(T_earlier_later.linear().transpose() * motion.linear());
  const Eigen::Matrix3d turn = Eigen::Matrix3d::Identity() + 0.5 * crossMatrix(error);
  Jacobians by;
  by.earlier.topLeftCorner<3, 3>() = -turn * motion.linear().transpose();
  by.earlier.bottomLeftCorner<3, 3>() = crossMatrix(motion.translation());
  by.earlier.bottomRightCorner<3, 3>() = -Eigen::Matrix3d::Identity();
  by.later.topLeftCorner<3, 3>() = turn;
  by.later.bottomRightCorner<3, 3>() = motion.linear();
  return by;
}

void
MeasuredMotion::linearize(const Poses& poses,
                          const Matrix6& information,
                          PoseSystem& system,
                          std::vector<Vector6>& gradient) const
{
  const Jacobians by = jacobians(poses);
  const Vector6 weighted = information * residual(poses);
  const std::size_t row = later - 1;
  system.add(row, row, by.later.transpose() * information * by.later);
  gradient[row] += by.later.transpose() * weighted;
  if (earlier == 0)
    return;
  const std::size_t other = earlier - 1;
  system.add(other, other, by.earlier.transpose() * information * by.earlier);
  system.add(row, other, by.later.transpose() * information * by.earlier);
  gradient[other] += by.earlier.transpose() * weighted;
}

Matrix6
MeasuredMotion::covariance(const Poses& poses, const PoseSystem& inverse) const
{
  const Jacobians by = jacobians(poses);
  const std::size_t row = later - 1;
  Matrix6 sum = by.later * inverse.inverse(row, row) * by.later.transpose();
  if (earlier == 0)
    return sum;
  const std::size_t other = earlier - 1;
  const Matrix6 shared =
      by.earlier * inverse.inverse(other, row) * by.later.transpose();
  sum += by.earlier * inverse.inverse(other, other) * by.earlier.transpose() + shared +
         shared.transpose();
  return sum;
}

} // namespace pcl::acmap
