#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

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

} // namespace pcl::acmap
