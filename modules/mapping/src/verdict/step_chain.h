#pragma once

#include "scan_matching.h"

#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/map_verdict_types.h>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief A measured relative pose of two scans. */
struct PoseLink {
  std::size_t from = 0, to = 0;
  PlanarPose T_from_to;
  Eigen::Matrix3d covariance; ///< x, z, theta in the frame of \a from
};

/** \brief The steps of a trajectory, by scans and odometry together. */
struct StepChain {
  std::vector<PoseLink> links; ///< one a step
  std::vector<PoseLink> skips; ///< over two steps, by scans alone
  double inflation = 1;        ///< alpha, of the covariances of matches
};

/** \brief Matches successive scans, measures the noise of the odometry by these matches, and
 * fuses both.
 * \param[out] noise what was measured
 * \throws CancelledException when the progress callback requested to stop */
StepChain
chainOfSteps(const std::vector<BeamScan>& scans,
             const std::vector<PlanarPose>& odometry,
             const OdometryNoise& assumed,
             MeasuredOdometry& noise);

} // namespace pcl::acmap
