#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/point_types.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trajectory.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/pipeline/camera_path.h>
#include <pcl/pipeline/estimated_poses.h>
#include <pcl/pipeline/observation_sequence.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Two observations between which a motion was estimated. \ingroup pipeline */
struct OdometryPair {
  std::size_t now = 0, before = 0; ///< indices in the sequence
  EgomotionReport report;
  std::optional<EgomotionEstimate> estimate; ///< T_before_now

  /** \brief Number of observations between both. */
  std::size_t
  skipped() const
  {
    return now - before - 1;
  }

  /** \brief Reason why no motion was found, with the name of the view that caused it.
   * \param[in] names of the files of the sequence */
  ACMAP_EXPORT std::string
  reason(const std::vector<std::string>& names) const;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const OdometryPair& pair, Visitor&& visit)
{
  visit({"now"}, pair.now);
  visit({"before"}, pair.before);
  visit({"report"}, pair.report);
  visit({"estimate"}, pair.estimate);
}

/** \brief Poses of a sequence, and the motions that they were computed from.
 *
 * \ingroup pipeline */
struct VisualOdometryResult {
  std::vector<OdometryPair> pairs; ///< in the order in which they were tried

  /** \brief T_map_camera of each observation; empty if the observation is lost. */
  std::vector<std::optional<Eigen::Isometry3d>> poses;

  MotionModel model = MotionModel::Planar; ///< of the motions

  /** \brief From a few pairs with six degrees of freedom, about the y axis of the camera, unless
   * the model was stated as rigid. */
  FreeMotion free;

  /** \brief Number of observations with a pose. */
  ACMAP_EXPORT std::size_t
  posed() const;

  /** \brief Reason why an observation has no pose: the result of the first pair that
   * failed.
   * \param[in] names of the files of the sequence */
  ACMAP_EXPORT std::string
  reasonOf(std::size_t lost, const std::vector<std::string>& names) const;

  /** \brief What the path of the camera is, by \ref model and \ref free. */
  ACMAP_EXPORT CameraPathReport
  path() const;

  /** \brief Odometry noise for \ref EntropyRectification, the medians of the standard
   * deviations of the motions.
   * \return the default noise if no motion was found */
  ACMAP_EXPORT OdometryNoise
  noise() const;

  /** \brief The poses of those observations that have one, and \ref noise.
   * \param[in] stamps seconds, one per observation */
  ACMAP_EXPORT EstimatedPoses
  estimated(const std::vector<double>& stamps) const;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const VisualOdometryResult& result, Visitor&& visit)
{
  visit({"pairs"}, result.pairs);
  visit({"poses"}, result.poses);
  visit({"model"}, acmap::Named{result.model, acmap::motion_model_names});
  visit({"free_motion"}, result.free);
}

/** \brief Estimates the poses of a sequence from its observations alone: the motions of
 * \ref VisualEgomotion, II-B.1 of "Active Stereo Based Compact Mapping", one after the
 * other.
 *
 * An observation that cannot be joined to the one before is tried against the two posed
 * ones before that, with search limits that grow with the gap; otherwise it is lost.
 * The map is the frame of the first observation that another one could be joined to. If
 * the motion model is planar, up to five pairs are also tried with six degrees of
 * freedom (\ref FreeMotion). Every observation is read once, and the next one is read
 * while the motion of the last one is estimated; three are kept in memory in addition
 * to the cache of the sequence.
 * Observations without an image, of one row or without colours, are laid onto each other by
 * their surfaces, with six degrees of freedom (doc/pipeline/visual_odometry.md).
 * \code
 * pcl::VisualOdometry odometry;
 * const pcl::VisualOdometryResult found =
 *     odometry.compute (pcl::ObservationSequence ("observations"));
 * std::cout << found.posed () << " poses\n";
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT VisualOdometry : public StageControls<Report> {
public:
  using Egomotion = VisualEgomotion<PointXYZRGBSigma>;

  /** \brief Called with each pair after it was tried. The egomotion has its matches and
   * views. */
  using PairCallback = std::function<void(const OdometryPair&, const Egomotion&)>;

  /** \brief Called with each observation as soon as it has a pose, in the order of the
   * sequence.
   * \param[in] index in the sequence */
  using PoseCallback = std::function<void(std::size_t index,
                                          const PointCloudFile& observation,
                                          const Eigen::Isometry3d& T_map_camera)>;

  /** \brief Sets the estimator of the motions: its motion model, keypoints and
   * refinement; its search limits are those from one observation to the next. Threads
   * and progress are those of this object. */
  void
  setEgomotion(const Egomotion& egomotion)
  {
    egomotion_ = egomotion;
  }

  const Egomotion&
  getEgomotion() const
  {
    return egomotion_;
  }

  /** \brief Finds out whether the camera moves freely (default false): if most of the first five
   * motions leave the floor, all are estimated with six degrees of freedom, else with the motion
   * model of the estimator. Has no effect in its paper mode, and if its model is rigid. */
  void
  setMeasureMotion(bool measure)
  {
    measure_motion_ = measure;
  }

  bool
  getMeasureMotion() const
  {
    return measure_motion_;
  }

  void
  setPairCallback(PairCallback callback)
  {
    pair_callback_ = std::move(callback);
  }

  const PairCallback&
  getPairCallback() const
  {
    return pair_callback_;
  }

  void
  setPoseCallback(PoseCallback callback)
  {
    pose_callback_ = std::move(callback);
  }

  const PoseCallback&
  getPoseCallback() const
  {
    return pose_callback_;
  }

  /** \brief Estimates the poses of a sequence.
   * \return the poses; a sequence of fewer than two observations has none
   * \throws InputFileException if an observation cannot be read, or differs in size from the
   * first one, or in whether it has an image; in paper mode if it has none
   * \throws CancelledException if the progress callback stopped it */
  VisualOdometryResult
  compute(const ObservationSequence& sequence);

private:
  Egomotion egomotion_;
  bool measure_motion_ = false;
  PairCallback pair_callback_;
  PoseCallback pose_callback_;
};

} // namespace pcl
