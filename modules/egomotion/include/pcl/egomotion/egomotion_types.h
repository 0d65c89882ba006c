#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/core/report.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>

namespace pcl {

/** \brief Model of the motion of a camera. \ingroup egomotion */
enum class MotionModel {
  Planar, ///< in the XZ plane and about y: the paper's action, 3 degrees of freedom
  Rigid   ///< any rigid motion, 6 degrees of freedom
};

/** \brief Method for minimising Eq. 2. \ingroup egomotion */
enum class MotionSolver {
  ConjugateGradient, ///< as in the paper
  ClosedForm         ///< without iterations
};

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

} // namespace pcl
