#pragma once

#include "rectification_maps.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/entropy_rectification.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Odometry noise: standard deviations for an action of length l and turn
 * dtheta. */
struct DriftModel {
  double length = 0;           ///< metres, of dx and dz, for any action
  double length_per_metre = 0; ///< added per metre of l
  double turn = 0;             ///< radians, for any action
  double turn_per_radian = 0;  ///< added per radian of |dtheta|
  double turn_bias = 0;        ///< radians, the same for each action
};

/** \brief Noise of a wheeled robot; level 1 is typical, other levels are factors. */
DriftModel
robotDrift(double level);

/** \brief Noise of a camera: 1 % of the length and 0.2 degrees from view to view. */
DriftModel
cameraDrift();

/** \brief Poses from simulated odometry, starting with the true first pose. */
std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth,
        const DriftModel& drift,
        std::uint64_t seed);

/** \brief Result of rectifying a map. */
struct RectificationRun {
  std::string name; ///< of the map, with level and seed
  std::vector<PlanarPose> given, found;
  AbsoluteTrajectoryError before, after; ///< with the true first pose
  EntropyRectificationReport report;
  double seconds = 0; ///< CPU

  double
  ratio() const
  {
    return after.unaligned / before.unaligned;
  }

  double
  alignedRatio() const
  {
    return after.aligned / before.aligned;
  }
};

using Rectification = EntropyRectification<PointNormal>;

/** \brief Rectifies a map on one thread.
 * \param[in] configure changes default settings */
RectificationRun
rectifyMap(const RectificationMap& map,
           const std::vector<PlanarPose>& given,
           const std::function<void(Rectification&)>& configure = {});

std::string
nameOf(RectificationOutcome outcome);

} // namespace pcl::acmap::bench
