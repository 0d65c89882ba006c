#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/core/report.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>

namespace pcl {

/** \brief How an egomotion ended. All but Estimated are failures: there is no motion
 * then.
 * \ingroup egomotion */
enum class EgomotionOutcome {
  Estimated,
  BlankView,    ///< a view shows nothing to recognise, or has no points
  FewFeatures,  ///< too few keypoints in a view
  FewMatches,   ///< too few look alike
  Inconsistent, ///< too few of those agree on a rigid motion
  Unobservable  ///< what agrees leaves a direction or turn open
};

/** \brief A motion from one view to the next. \ingroup egomotion */
struct EgomotionEstimate {
  /** Takes points of the source (the later view) into the target's frame, metres. */
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  /** The same on the floor; of a Rigid motion its planar part. */
  PlanarAction action;
  /** Of small motions (tx, ty, tz in metres, rx, ry, rz in radians) in the target's
   * frame after T_target_source; rows of what a Planar motion cannot do are 0. */
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/** \brief What VisualEgomotion tells about its last run. \ingroup egomotion */
struct EgomotionReport : Report {
  EgomotionOutcome outcome = EgomotionOutcome::BlankView; ///< of a run
  std::string reason;                                     ///< of a failure, one line
  std::size_t source_points = 0, target_points = 0;       ///< with a place
  std::size_t source_keypoints = 0, target_keypoints = 0;
  std::size_t matches = 0;    ///< alike
  std::size_t consistent = 0; ///< of these, after leaving the worst out
  std::size_t inliers = 0; ///< of these, within three standard deviations of the motion
  double feature_residual = 0; ///< metres, rms between inliers after the motion
  double feature_chi = 0;  ///< the same in standard deviations: 1 when sigma is right
  bool is_refined = false; ///< did the surfaces improve the motion?
  std::size_t surface_pairs = 0; ///< pieces of surface compared
  double surface_before =
      0;                    ///< metres, rms between surfaces under the features' motion
  double surface_after = 0; ///< metres, under the refined one
  /** Share of the surfaces that would hide, in the other view, what that has seen. */
  double contradicted = 0;
};

} // namespace pcl
