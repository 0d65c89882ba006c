#include <pcl/core/exceptions.h>
#include <pcl/core/rigid_motion.h>

#include <Eigen/SVD>

namespace pcl::acmap {

namespace {

constexpr double exact = 1e-9; // deviation that the digits of a double explain

double
deviationOf(const Eigen::Matrix3d& rotation)
{
  return (rotation.transpose() * rotation - Eigen::Matrix3d::Identity())
      .cwiseAbs()
      .maxCoeff();
}

Eigen::Matrix3d
nearestRotation(const Eigen::Matrix3d& axes)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

} // namespace

bool
isRigid(const Eigen::Isometry3d& pose, double tolerance)
{
  const Eigen::Matrix3d rotation = pose.linear();
  return pose.matrix().allFinite() && deviationOf(rotation) <= tolerance &&
         rotation.determinant() > 0;
}

Eigen::Isometry3d
RigidMotion::rigid(const Eigen::Matrix4d& pose)
{
  const Eigen::Matrix3d rotation = pose.topLeftCorner<3, 3>();
  constexpr const char* no_motion = "a pose is no rigid motion: ";
  if (!pose.allFinite())
    throw BadArgument(no_motion, "it has a value that is not finite");
  if (pose.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    throw BadArgument(no_motion, "its last row is not 0 0 0 1");
  const double deviation = deviationOf(rotation);
  if (deviation > pose_tolerance)
    throw BadArgument(no_motion,
                      "the products of its axes deviate by ",
                      deviation,
                      " from those of a rotation, at most ",
                      pose_tolerance,
                      " is rounded away");
  if (rotation.determinant() < 0)
    throw BadArgument(no_motion, "it mirrors");
  Eigen::Isometry3d motion(pose);
  if (deviation > exact)
    motion.linear() = nearestRotation(rotation);
  return motion;
}

const RigidMotion&
requirePlace(const RigidMotion& pose)
{
  constexpr double farthest = 1e9; // metres
  if (pose.get().translation().cwiseAbs().maxCoeff() > farthest)
    throw BadArgument("a pose is more than 1e9 m from the origin along an axis");
  return pose;
}

} // namespace pcl::acmap
