#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

class ScanSurface;

/** \brief An observation of a sequence as input of pcl::VisualEgomotion, or of
 * \ref matchScans if it has no image. */
struct OdometryView {
  std::size_t index = 0;                        ///< index in the sequence
  std::shared_ptr<const PointCloudFile> file;   ///< camera frame, metres
  PointCloud<PointXYZRGBSigma>::ConstPtr cloud; ///< null without an image
  std::shared_ptr<const ScanSurface> surface;   ///< null with one
};

/** \brief An observation as input of the egomotion: with its image if it is organized and has
 * colours, otherwise with its surface. */
OdometryView
odometryView(std::size_t index, std::shared_ptr<const PointCloudFile> observation);

/** \brief The same for an observation that is read from its sequence. */
OdometryView
odometryView(const ObservationSequence& sequence, std::size_t index);

/** \brief Joins views to the last ones that have a pose, one after the other.
 *
 * Each view is tried against the previous one, then against the two posed ones before
 * that; if no motion is found it is lost, and gets no pose. The map is the frame of the
 * first view that another one could be joined to: until there is a motion, the last
 * three views are kept as possible origins, so that a bad first one does not spoil the
 * rest. At most three views are kept. */
class PoseChain {
public:
  /** \brief Returns T_before_now, or nothing if the motion could not be estimated. */
  using Estimate = std::function<std::optional<Eigen::Isometry3d>(
      const OdometryView& now, const OdometryView& before)>;

  /** \brief Called with each view as soon as it has a pose, in the order of the
   * sequence. */
  using Keep = std::function<void(const OdometryView& view,
                                  const Eigen::Isometry3d& T_map_camera)>;

  PoseChain(Estimate estimate, Keep keep)
  : estimate_(std::move(estimate))
  , keep_(std::move(keep))
  {}

  /** \brief Adds the next view of the sequence. */
  void
  add(OdometryView now);

private:
  struct Anchor {
    OdometryView view;
    Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  };

  void
  beginWith(Anchor first);

  void
  hold(Anchor anchor);

  Estimate estimate_;
  Keep keep_;
  bool has_begun_ = false;
  /** \brief The last posed views; until the first motion is found, the possible first
   * views. */
  std::deque<Anchor> anchors_;
};

/** \brief A run of VisualOdometry: observations are added one after the other, as soon as
 * each is there. */
class OdometryRun {
public:
  using Egomotion = VisualOdometry::Egomotion;

  explicit OdometryRun(const VisualOdometry& settings);

  OdometryRun(const OdometryRun&) = delete; // the chain refers to this object
  OdometryRun&
  operator=(const OdometryRun&) = delete;

  /** \brief Is told the progress of each motion, and can cancel the run. */
  void
  setProgressCallback(ProgressCallback progress);

  /** \brief Adds the next observation.
   * \param[in] view with the number of views before as its index
   * \throws InputFileException if its size is not that of the first one, only one of both has
   * an image, or it has none in the paper's mode
   * \throws CancelledException if the progress callback stopped it */
  void
  add(OdometryView view, const std::string& name);

  /** \brief Poses and pairs so far. */
  const VisualOdometryResult&
  result() const
  {
    return result_;
  }

  /** \brief Completes the result, after the last observation.
   * \param[in] observations number of these; further ones are left out */
  const VisualOdometryResult&
  finish(std::size_t observations);

private:
  PoseChain
  newChain();

  void
  probeFreeMotion(const OdometryView& now);

  /** \brief Chooses the motion model by the first observations, which are estimated again where
   * the camera moves freely. */
  void
  chooseModel();

  std::optional<Eigen::Isometry3d>
  estimate(const OdometryView& now, const OdometryView& before);

  std::optional<EgomotionEstimate>
  estimateOfSurfaces(const OdometryView& now,
                     const OdometryView& before,
                     EgomotionReport& report);

  void
  requireSameKind(const OdometryView& view, const std::string& name);

  void
  keep(const OdometryView& view, const Eigen::Isometry3d& T_map_camera);

  Egomotion of_step_; ///< with the limits from one observation to the next
  Egomotion egomotion_;
  VisualOdometry::PairCallback pair_callback_;
  VisualOdometry::PoseCallback pose_callback_;
  VisualOdometryResult result_;
  std::string size_;                ///< of the first observation's image
  std::vector<OdometryView> first_; ///< until the motion model is chosen
  bool chooses_model_;
  OdometryView last_;                                           ///< without its file
  Eigen::Isometry3d last_step_ = Eigen::Isometry3d::Identity(); ///< of surfaces
  std::vector<double> tilts_, rises_; ///< of \ref FreeMotion, radians and metres
  PoseChain chain_;
};

} // namespace pcl::acmap
