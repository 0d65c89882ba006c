#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief Outcome of PlaneAdjustment. \ingroup mapping */
enum class AdjustmentOutcome {
  Adjusted,    ///< the poses were adjusted
  Kept,        ///< the planes fit the given poses within noise: poses unchanged
  Refused,     ///< the rays contradict the adjusted poses more than the given ones
  Undetermined ///< no plane is seen from two views: the poses are unchanged
};

namespace acmap {

/** \brief The names of \ref AdjustmentOutcome in files and in Python. */
inline constexpr std::array<const char*, 4> adjustment_outcome_names{
    "adjusted", "kept", "refused", "undetermined"};

} // namespace acmap

/** \brief One association of pieces and the steps that follow it. \ingroup mapping */
struct AdjustmentRound {
  double gate = 0;           ///< metres, largest distance across a plane
  double floor = 0;          ///< metres, systematic error assumed at 2 m
  std::size_t landmarks = 0; ///< planes seen from several views
  std::size_t pieces = 0;    ///< pieces on these planes
  double prior = 0;          ///< chi^2 of the odometry per degree of freedom
  double thickness = 0;      ///< metres, as PlaneAdjustmentReport::thickness_after
  double moved = 0;          ///< metres, farthest move of a pose in this round
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const AdjustmentRound& round, Visitor&& visit)
{
  visit({"gate", "m"}, round.gate);
  visit({"floor", "m"}, round.floor);
  visit({"landmarks"}, round.landmarks);
  visit({"pieces"}, round.pieces);
  visit({"prior"}, round.prior);
  visit({"thickness", "m"}, round.thickness);
  visit({"moved", "m"}, round.moved);
}

/** \brief Contradictions of a set of poses by rays: a ray is contradicted if it passes
 * through a plane piece that another view has seen, and confirmed if it ends on one.
 * The share is the number of contradicted rays divided by the sum of both. Near views
 * are at most 16 views apart, far ones are the others. \ingroup mapping */
struct RayContradictions {
  std::size_t near_rays = 0, far_rays = 0; ///< rays with evidence
  double near_share = 0, far_share = 0;    ///< 0 without evidence
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RayContradictions& rays, Visitor&& visit)
{
  visit({"near_rays"}, rays.near_rays);
  visit({"far_rays"}, rays.far_rays);
  visit({"near_share"}, rays.near_share);
  visit({"far_share"}, rays.far_share);
}

/** \brief Standard deviation of a pose with respect to the first one. \ingroup mapping */
struct PoseUncertainty {
  double position = 0; ///< metres, square root of the trace of the covariance
  double rotation = 0; ///< radians, likewise
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PoseUncertainty& pose, Visitor&& visit)
{
  visit({"position", "m"}, pose.position);
  visit({"rotation", "rad"}, pose.rotation);
}

/** \brief Report of PlaneAdjustment on its last run. \ingroup mapping */
struct PlaneAdjustmentReport : Report {
  AdjustmentOutcome outcome = AdjustmentOutcome::Undetermined;
  std::string reason; ///< reason of the outcome, one line
  std::size_t views = 0, points = 0, invalid_points = 0;
  std::size_t pieces = 0;            ///< plane pieces of all views
  std::size_t landmarks = 0;         ///< planes seen from several views, last round
  std::size_t associated_pieces = 0; ///< pieces on these planes
  std::size_t attempts = 0; ///< searches: more than one where the first was doubtful
  double noise_factor = 1;  ///< measured noise at 2 m, as a factor of the given sigma;
                            ///< metres if none was given
  double floor = 0;         ///< metres, systematic error of a view at 2 m
  /** Factors on the standard deviations of rotations and translations of the odometry
   * that its residuals indicate. */
  std::array<double, 2> odometry_factors{1, 1};
  double prior = 0; ///< chi^2 of the odometry per degree of freedom
  /** Metres: root mean square over planes and views of the distance of a view's points
   * from the plane that all views share, under the given and the adjusted poses. */
  double thickness_before = 0, thickness_after = 0;
  /** Decrease of chi^2 of the planes by the adjustment, in excess of what adjusting to
   * noise gives, in standard deviations of the latter. */
  double significance = 0;
  std::size_t revisits_used = 0;    ///< revisits that agree with the adjusted poses
  std::size_t revisits_dropped = 0; ///< revisits that other evidence contradicts
  RayContradictions rays_before, rays_after;
  std::vector<AdjustmentRound> rounds;
  std::vector<PoseUncertainty> uncertainty; ///< for each view
  std::vector<double> moved;                ///< metres, for each view
  std::vector<double> turned;               ///< radians, for each view
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PlaneAdjustmentReport& report, Visitor&& visit)
{
  visit({"outcome"}, acmap::Named{report.outcome, acmap::adjustment_outcome_names});
  visit({"reason"}, report.reason);
  visit({"views"}, report.views);
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"pieces"}, report.pieces);
  visit({"planes"}, report.landmarks);
  visit({"associated_pieces"}, report.associated_pieces);
  visit({"noise_factor"}, report.noise_factor);
  visit({"floor", "m"}, report.floor);
  visit({"attempts"}, report.attempts);
  visit({"odometry_factors"}, report.odometry_factors);
  visit({"prior"}, report.prior);
  visit({"thickness_before", "m"}, report.thickness_before);
  visit({"thickness_after", "m"}, report.thickness_after);
  visit({"significance"}, report.significance);
  visit({"revisits_used"}, report.revisits_used);
  visit({"revisits_dropped"}, report.revisits_dropped);
  visit({"rays_before"}, report.rays_before);
  visit({"rays_after"}, report.rays_after);
  visit({"moved", "m"}, report.moved);
  visit({"turned", "rad"}, report.turned);
  visit({"rounds"}, report.rounds);
  visit({"uncertainty"}, report.uncertainty);
}

} // namespace pcl
