#pragma once

#include <pcl/core/report.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief How EntropyRectification searches. \ingroup mapping */
enum class RectificationMode {
  Guarded, ///< descent on the direction-aware entropy with an odometry prior, judged by rays
  Paper ///< voting on subsets of actions, on the entropy of Eq. 3 alone
};

/** \brief How it ended. \ingroup mapping */
enum class RectificationOutcome {
  Rectified,   ///< the poses are new
  Kept,        ///< the map was as good before: the poses are as they came
  Refused,     ///< the rays spoke against every candidate: the poses are as they came
  Undetermined ///< there was nothing to go by: the poses are as they came
};

/** \brief What a robot's odometry is expected to err by, one standard deviation for one
 * action of length l and turn dtheta. \ingroup mapping */
struct OdometryNoise {
  double length = 0.005;          ///< metres, on dx and on dz, of any action
  double length_per_metre = 0.03; ///< added for each metre of l
  double turn = 0.006;            ///< radians, of any action
  double turn_per_radian = 0.02;  ///< added for each radian of |dtheta|
};

/** \brief A point of the energy curve. \ingroup mapping */
struct RectificationStep {
  std::string search;  ///< which one
  double bin_size = 0; ///< metres
  double entropy = 0;  ///< bits, at this bin size; Guarded: less that in wide bins
  double prior = 0;    ///< half the squared sum of the actions' residuals, in sigmas
  double energy = 0;   ///< what is minimised: both, weighted
};

/** \brief What the rays of a map and its points tell; the search uses none of it.
 *
 * A ray is contradicted where it passes through a wall that another observation has
 * seen, confirmed where it ends on one. The share is contradicted over both. Near are
 * observations at most 16 apart, far the others. \ingroup mapping */
struct MapEvidence {
  std::size_t rays = 0;
  double near_contradictions = 0; ///< share, 0 without any near evidence
  double far_contradictions = 0;  ///< share, 0 without any far evidence
  double near_rays = 0;           ///< share of the rays that near walls tell about
  double far_rays = 0;            ///< share of the rays that far walls tell about
  /** Nats, mean over points of the entropy of their neighbourhood, 0.4 m in XZ. */
  double mean_map_entropy = 0;
  /** m^2, mean variance across walls along the building's two main directions. */
  double orthogonal_variance = 0;
};

/** \brief What EntropyRectification tells about its last run. \ingroup mapping */
struct EntropyRectificationReport : Report {
  RectificationOutcome outcome = RectificationOutcome::Undetermined;
  std::string reason; ///< of the outcome, one line
  std::size_t observations = 0, points = 0, invalid_points = 0;
  std::size_t evaluations = 0; ///< of the energy of the whole map, or as much work
  double odometry_scale = 1;   ///< times OdometryNoise: what the rays preferred
  double strongest_action = 0; ///< largest residual of an action, in sigmas
  double disagreement = 0;     ///< metres, rms, between the two best candidates
  std::vector<RectificationStep> steps;
  MapEvidence before, after;  ///< after: of the best candidate, even when refused
  std::vector<double> moved;  ///< metres, each observation
  std::vector<double> turned; ///< radians, each observation
};

} // namespace pcl
