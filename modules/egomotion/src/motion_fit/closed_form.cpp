#include "motion_fit/rotation_fit.h"

#include <Eigen/SVD>

#include <cmath>

namespace pcl::acmap {

namespace {

Eigen::Quaterniond
planarRotation(const Eigen::Matrix3d& cross, double open)
{
  const double sine = cross(0, 2) - cross(2, 0);
  const double cosine = cross(0, 0) + cross(2, 2);
  if (std::hypot(sine, cosine) <= open)
    return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(std::atan2(sine, cosine), Eigen::Vector3d::UnitY()));
}

Eigen::Quaterniond
rigidRotation(const Eigen::Matrix3d& cross, double open)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d &u = svd.matrixU(), &v = svd.matrixV();
  if (svd.singularValues()[0] <= open)
    return Eigen::Quaterniond::Identity();
  // All points are on a line: the smallest rotation, without rotation about the line.
  if (svd.singularValues()[1] <= open)
    return Eigen::Quaterniond::FromTwoVectors(v.col(0), u.col(0));
  const Eigen::Vector3d mirror(1, 1, (u * v.transpose()).determinant() < 0 ? -1 : 1);
  return Eigen::Quaterniond(Eigen::Matrix3d(u * mirror.asDiagonal() * v.transpose()));
}

} // namespace

Eigen::Quaterniond
closedFormRotation(const PairMoments& moments, MotionModel model)
{
  const double open =
      open_part * std::sqrt(moments.spread.trace() * moments.target_spread);
  return model == MotionModel::Planar ? planarRotation(moments.cross, open)
                                      : rigidRotation(moments.cross, open);
}

} // namespace pcl::acmap
