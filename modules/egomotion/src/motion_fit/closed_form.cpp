#include "motion_fit/rotation_fit.h"

#include <pcl/core/impl/rigid_alignment.h>

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

} // namespace

Eigen::Quaterniond
closedFormRotation(const PairMoments& moments, MotionModel model)
{
  const double open =
      open_part * std::sqrt(moments.spread.trace() * moments.target_spread);
  return model == MotionModel::Planar
             ? planarRotation(moments.cross, open)
             : Eigen::Quaterniond(alignmentRotation<3>(moments.cross, open));
}

} // namespace pcl::acmap
