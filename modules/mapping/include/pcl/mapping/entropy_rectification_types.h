#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/report.h>
#include <pcl/mapping/map_verdict_types.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Search mode of EntropyRectification. \ingroup mapping */
enum class RectificationMode {
  /** Descent on the direction-aware entropy with an odometry prior, verified by
   * rays. */
  Guarded,
  /** Voting on subsets of actions, on the exact entropy of Eq. 3 of all points. */
  Paper
};

namespace acmap {

/** \brief The names of \ref RectificationMode in files and in Python. */
inline constexpr std::array<const char*, 2> rectification_mode_names{"guarded",
                                                                     "paper"};

} // namespace acmap

/** \brief Outcome of EntropyRectification. \ingroup mapping */
enum class RectificationOutcome {
  Rectified,   ///< the poses were rectified
  Kept,        ///< the given map was as good: the poses are unchanged
  Refused,     ///< the rays contradict all candidates: poses unchanged
  Undetermined ///< there is no information: the poses are unchanged
};

namespace acmap {

/** \brief The names of \ref RectificationOutcome in files and in Python. */
inline constexpr std::array<const char*, 4> rectification_outcome_names{
    "rectified", "kept", "refused", "undetermined"};

} // namespace acmap

/** \brief Expected errors of a robot's odometry: standard deviations for an action of
 * length l and turn dtheta. \ingroup mapping */
struct OdometryNoise {
  double length = 0.005;          ///< metres, of dx and of dz, for any action
  double length_per_metre = 0.03; ///< added for each metre of l
  double turn = 0.006;            ///< radians, for any action
  double turn_per_radian = 0.02;  ///< added for each radian of |dtheta|
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const OdometryNoise& noise, Visitor&& visit)
{
  visit({"length", "m"}, noise.length);
  visit({"length_per_metre"}, noise.length_per_metre);
  visit({"turn", "rad"}, noise.turn);
  visit({"turn_per_radian"}, noise.turn_per_radian);
}

/** \brief A point of the energy curve. \ingroup mapping */
struct RectificationStep {
  std::string search;  ///< name of the search
  double bin_size = 0; ///< metres
  double entropy = 0;  ///< bits, at this bin size; Guarded: minus that of wide bins
  double prior = 0;    ///< half the sum of squared residuals of the actions, in sigmas
  double energy = 0;   ///< minimised value: weighted sum of both
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RectificationStep& step, Visitor&& visit)
{
  visit({"search"}, step.search);
  visit({"bin_size", "m"}, step.bin_size);
  visit({"entropy", "bits"}, step.entropy);
  visit({"prior"}, step.prior);
  visit({"energy"}, step.energy);
}

/** \brief Evidence from the rays and points of a map, which the search does not use.
 *
 * A ray is contradicted if it passes through a wall that another observation has seen,
 * and confirmed if it ends on such a wall. The share is the number of contradicted rays
 * divided by the sum of both. Near observations are at most 16 observations apart, far
 * ones are the others. \ingroup mapping */
struct MapEvidence {
  std::size_t rays = 0;
  double near_contradictions = 0; ///< share, 0 without any near evidence
  double far_contradictions = 0;  ///< share, 0 without any far evidence
  double near_rays = 0;           ///< share of the rays with evidence by near walls
  double far_rays = 0;            ///< share of the rays with evidence by far walls
  /** Largest share of contradicted rays between two groups of eight successive
   * observations: the lower end of its confidence interval, so that a few rays do not
   * count. A wrong revisit shows in some pairs although the shares of all rays are
   * small. */
  double pair_contradictions = 0;
  /** Share of the rays between far groups that are contradicted in pairs where more
   * than half are, with confidence. People and moved doors explain a few percent. */
  double contradicted_pairs = 0;
  /** Mean map entropy in nats: mean over points of the entropy of their neighbourhood,
   * 0.4 m in XZ. */
  double mean_map_entropy = 0;
  /** Mean variance across walls along the two main directions of the building, m^2. */
  double orthogonal_variance = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MapEvidence& evidence, Visitor&& visit)
{
  visit({"rays"}, evidence.rays);
  visit({"near_contradictions"}, evidence.near_contradictions);
  visit({"far_contradictions"}, evidence.far_contradictions);
  visit({"near_rays"}, evidence.near_rays);
  visit({"far_rays"}, evidence.far_rays);
  visit({"pair_contradictions"}, evidence.pair_contradictions);
  visit({"contradicted_pairs"}, evidence.contradicted_pairs);
  visit({"mean_map_entropy", "nats"}, evidence.mean_map_entropy);
  visit({"orthogonal_variance", "m^2"}, evidence.orthogonal_variance);
}

/** \brief Report of the last run of EntropyRectification. \ingroup mapping */
struct EntropyRectificationReport : Report {
  RectificationOutcome outcome = RectificationOutcome::Undetermined;
  std::string reason; ///< reason of the outcome, one line
  /** \brief Up direction of the map that was assumed. */
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  bool is_up_found = false; ///< Was it given, or shown by the surfaces?
  std::string up_reason;    ///< one line: what determined it
  std::size_t observations = 0, points = 0, invalid_points = 0;
  std::size_t evaluations = 0; ///< of the energy of the whole map, or equivalent
  std::size_t votes = 0; ///< Paper: changes of a subset of actions that were tried
  std::size_t accepted_moves = 0; ///< Paper: votes that lowered the energy
  double odometry_scale = 1;      ///< factor of OdometryNoise that was assumed
  double strongest_action = 0;    ///< largest residual of an action, in sigmas
  double disagreement = 0;        ///< metres, rms, between the two best candidates
  /** \brief Metres, 95 %: how far the position of the pose that is known least, relative to
   * the first one, may be wrong in the map that was rectified or kept, by an estimate from
   * neighbouring walls and the odometry that is independent of the entropy. */
  std::optional<double> expected_error;
  /** \brief The verdict on the poses that were found, by an estimate of its own; nothing
   * unless the observations are scans of a planar laser (Guarded mode). */
  std::optional<MapVerdictReport> verdict;
  /** \brief The poses that the verdict did not accept, in a frame whose y axis points down;
   * empty if there are none. */
  std::vector<PlanarPose> refused_poses;
  std::vector<RectificationStep> steps;
  MapEvidence before, after;  ///< after: of the best candidate, even if refused
  std::vector<double> moved;  ///< metres, for each observation
  std::vector<double> turned; ///< radians, for each observation
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const EntropyRectificationReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"outcome"}, acmap::Named{report.outcome, acmap::rectification_outcome_names});
  visit({"reason"}, report.reason);
  visit({"up"}, report.up);
  visit({"is_up_found"}, report.is_up_found);
  visit({"up_reason"}, report.up_reason);
  visit({"evaluations"}, report.evaluations);
  visit({"votes"}, report.votes);
  visit({"accepted_moves"}, report.accepted_moves);
  visit({"odometry_scale"}, report.odometry_scale);
  visit({"strongest_action"}, report.strongest_action);
  visit({"disagreement", "m"}, report.disagreement);
  visit({"expected_error", "m"}, report.expected_error);
  visit({"verdict"}, report.verdict);
  visit({"refused_poses"}, report.refused_poses);
  visit({"before"}, report.before);
  visit({"after"}, report.after);
  visit({"moved", "m"}, report.moved);
  visit({"turned", "rad"}, report.turned);
  visit({"steps"}, report.steps);
}

} // namespace pcl
