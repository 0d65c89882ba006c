#pragma once

#include "rectification_maps.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/entropy_rectification.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief What an odometry errs by, one standard deviation for an action of length l and
 * turn dtheta. */
struct Drift {
  double length = 0;           ///< metres, on dx and on dz, of any action
  double length_per_metre = 0; ///< added for each metre of l
  double turn = 0;             ///< radians, of any action
  double turn_per_radian = 0;  ///< added for each radian of |dtheta|
  double turn_bias = 0;        ///< radians, the same for each action
};

/** \brief A wheeled robot's; level 1 is a usual one, others are so many times as bad. */
Drift
robotDrift(double level);

/** \brief A camera's: 1 % of the length and 0.2 degrees from view to view. */
Drift
cameraDrift();

/** \brief The poses that such an odometry tells, from the true first one on. */
std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth, const Drift& drift, std::uint64_t seed);

/** \brief A map rectified. */
struct RectificationRun {
  std::string name; ///< of the map, with level and seed
  std::vector<PlanarPose> given, found;
  AbsoluteTrajectoryError before, after; ///< the first pose is the true one
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

/** \brief Rectifies on one thread.
 * \param[in] configure sets what is not as usual */
RectificationRun
rectifyMap(const RectificationMap& map,
           const std::vector<PlanarPose>& given,
           const std::function<void(Rectification&)>& configure = {});

std::string
nameOf(RectificationOutcome outcome);

} // namespace pcl::acmap::bench
