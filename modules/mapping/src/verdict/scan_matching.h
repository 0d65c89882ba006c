#pragma once

#include "beam_scan.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Standard deviations about the start of a match. */
struct MatchPrior {
  double length = 0.5, turn = 0.5; ///< metres, radians
  double reach = 0.8;              ///< metres, from a point to its line, at first
};

/** \brief A scan placed in the frame of another one. */
struct ScanMatch {
  PlanarPose T_i_j;
  PairScore score;
  /** \brief Information of x, z and theta without what noisy normals feign. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /** \brief Spread of other places which fit nearly as well. */
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

/** \brief A pose that is given in the frame of another one. */
inline PlanarPose
composed(const PlanarPose& a, const PlanarPose& b)
{
  return moved(a, {b.x, b.z, b.theta});
}

/** \brief The pose \a to in the frame of \a from. */
inline PlanarPose
relative(const PlanarPose& from, const PlanarPose& to)
{
  const PlanarAction action = actionBetween(from, to);
  return {action.dx, action.dz, action.dtheta};
}

/** \brief A scan placed in its predecessor, and how well the odometry's step fits. */
struct StepMatch {
  ScanMatch best;
  double odometry_merit = 0; ///< L at the odometry's step
};

/** \brief The difference of two placements: x, z, theta. */
Eigen::Vector3d
differenceOf(const PlanarPose& a, const PlanarPose& b);

/** \brief Places scan \a j in scan \a i by point-to-line ICP. */
ScanMatch
matchScans(const BeamScan& i,
           const BeamScan& j,
           const PlanarPose& start,
           const MatchPrior& prior = {});

/** \brief Places a scan in its predecessor, from the step of the odometry and, if they do
 * not fit there, from others about it. */
StepMatch
matchStep(const BeamScan& i, const BeamScan& j, const PlanarPose& odometry);

/** \brief Covariance of a match.
 * \param[in] doubt factor of the covariance: 4 alpha of steps, 16 alpha of revisits */
Eigen::Matrix3d
covarianceOf(const ScanMatch& match, double doubt);

} // namespace pcl::acmap
