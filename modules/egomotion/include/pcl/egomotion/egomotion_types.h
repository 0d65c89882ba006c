#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/report.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>

namespace pcl {

/** \brief Model of the motion of a camera. \ingroup egomotion */
enum class MotionModel {
  Planar, ///< in the XZ plane and about y: the paper's action, 3 degrees of freedom
  Rigid   ///< any rigid motion, 6 degrees of freedom
};

namespace acmap {

/** \brief The names of \ref MotionModel in files and in Python. */
inline constexpr std::array<const char*, 2> motion_model_names{"planar", "rigid"};

} // namespace acmap

/** \brief Method for minimising Eq. 2. \ingroup egomotion */
enum class MotionSolver {
  ConjugateGradient, ///< as in the paper
  ClosedForm         ///< without iterations
};

namespace acmap {

inline constexpr std::array<const char*, 2> motion_solver_names{"conjugate gradient",
                                                                "closed form"};

} // namespace acmap

/** \brief Outcome of an egomotion. All except Estimated are failures without a motion.
 * \ingroup egomotion */
enum class EgomotionOutcome {
  Estimated,
  BlankView,    ///< a view contains nothing to recognise, or has no points
  FewFeatures,  ///< too few keypoints in a view
  FewMatches,   ///< too few keypoints have a similar appearance
  Inconsistent, ///< too few matches agree, or surfaces or bounds contradict the motion
  Unobservable  ///< a translation or rotation is not determined by the inliers
};

namespace acmap {

/** \brief The names of \ref EgomotionOutcome in files and in Python. */
inline constexpr std::array<const char*, 6> egomotion_outcome_names{"estimated",
                                                                    "blank view",
                                                                    "few features",
                                                                    "few matches",
                                                                    "inconsistent",
                                                                    "unobservable"};

} // namespace acmap

/** \brief A motion from one view to the next. \ingroup egomotion */
struct EgomotionEstimate {
  /** Maps points of the source (the later view) to the target's frame, metres. */
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  /** The same motion on the floor; for a Rigid motion, its planar part. */
  PlanarAction action;
  /** Covariance of small motions (tx, ty, tz in metres, rx, ry, rz in radians) in the
   * target's frame after T_target_source; rows outside the Planar model are 0. In paper
   * mode, where points have no sigma, from the residuals of the fit: that of least
   * squares with equal and independent errors. The paper gives none. */
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const EgomotionEstimate& estimate, Visitor&& visit)
{
  visit({"T_target_source"}, estimate.T_target_source);
  visit({"action"}, estimate.action);
  visit({"covariance"}, estimate.covariance);
}

/** \brief Report of VisualEgomotion on its last run. \ingroup egomotion */
struct EgomotionReport : Report {
  EgomotionOutcome outcome = EgomotionOutcome::BlankView; ///< of the run
  std::string reason;                                     ///< of a failure, one line
  std::size_t source_points = 0, target_points = 0;       ///< valid points
  std::size_t source_keypoints = 0, target_keypoints = 0;
  std::size_t matches = 0;     ///< similar in appearance
  std::size_t consistent = 0;  ///< matches that remain after leaving the worst out
  std::size_t removed = 0;     ///< matches removed by leaving the worst out
  bool is_paper = false;       ///< was the run in paper mode?
  std::size_t fits = 0;        ///< minimisations of Eq. 2; 1 in paper mode
  std::size_t iterations = 0;  ///< of the conjugate gradient method in all these fits
  std::size_t inliers = 0;     ///< consistent matches within three standard deviations;
                               ///< in paper mode all consistent ones
  double feature_residual = 0; ///< RMS between inliers after the motion, metres
  double feature_chi = 0; ///< the same in standard deviations: 1 if sigma is correct; 0
                          ///< in paper mode
  bool is_refined = false;       ///< did the surfaces improve the motion?
  std::size_t surface_pairs = 0; ///< number of surface blocks that were compared
  double surface_before =
      0;                    ///< RMS between surfaces under the features' motion, metres
  double surface_after = 0; ///< RMS under the refined motion, metres
  /** Share of the surface blocks that would occlude what the other view has seen. */
  double contradicted = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const EgomotionReport& report, Visitor&& visit)
{
  visit({"outcome"}, acmap::Named{report.outcome, acmap::egomotion_outcome_names});
  visit({"reason"}, report.reason);
  visit({"points"}, report.source_points);
  visit({"points_before"}, report.target_points);
  visit({"keypoints"}, report.source_keypoints);
  visit({"keypoints_before"}, report.target_keypoints);
  visit({"matches"}, report.matches);
  visit({"consistent"}, report.consistent);
  visit({"removed"}, report.removed);
  visit({"is_paper"}, report.is_paper);
  visit({"fits"}, report.fits);
  visit({"iterations"}, report.iterations);
  visit({"inliers"}, report.inliers);
  visit({"feature_residual", "m"}, report.feature_residual);
  visit({"feature_chi"}, report.feature_chi);
  visit({"is_refined"}, report.is_refined);
  visit({"surface_pairs"}, report.surface_pairs);
  visit({"surface_before", "m"}, report.surface_before);
  visit({"surface_after", "m"}, report.surface_after);
  visit({"contradicted"}, report.contradicted);
}

} // namespace pcl
