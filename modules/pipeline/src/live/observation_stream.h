#pragma once

#include "live/provisional_mapping.h"
#include "motion/odometry_run.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace pcl::acmap {

/** \brief Projects the fused disparities of an observation.
 * \return the points, camera frame, metres */
std::shared_ptr<const PointCloudFile>
projectFused(DisparityFusion& fusion, DisparityBackProjection& projection);

/** \brief Processes observations in a thread of its own, each as soon as it is complete:
 * disparities, its motion since the one before, and its consolidated points. What it
 * computes is what the same steps compute of the whole sequence. */
class ObservationStream {
public:
  struct Steps {
    DisparityBackProjection projection;
    VisualOdometry odometry;
    SequenceConsolidation consolidation;
    std::string folder;       ///< for the observations; empty: they stay in memory
    bool keeps_clouds = true; ///< false: who adds them has them
    bool consolidates = true;
    std::size_t maximum_waiting = 8; ///< observations
    MappingStateCallback callback;
    double provisional_interval = 0; ///< seconds between provisional maps; 0: none
  };

  explicit ObservationStream(Steps steps);

  /** \brief Stops at once; what is not processed is lost. */
  ~ObservationStream();

  /** \brief Adds the shots of an observation; waits as long as too many wait already.
   * \throws InitFailedException after \ref finish
   * \throws what the processing of earlier ones has thrown */
  void
  add(DisparityFusion shots);

  /** \brief Adds an observation that was computed elsewhere; its motion is estimated if
   * it has no pose.
   * \param[in] name for messages; empty: by its number */
  void
  add(std::shared_ptr<const PointCloudFile> cloud,
      const std::optional<Eigen::Isometry3d>& T_map_camera,
      const std::string& name = {});

  /** \brief Number of observations that were added. */
  std::size_t
  size() const;

  /** \brief Waits until all observations are processed.
   * \throws what the processing has thrown, unless \ref keepProcessed was called */
  void
  finish();

  /** \brief After a fault of the processing: the results are those of the observations
   * before it. */
  void
  keepProcessed();

  /** \name Results, after \ref finish */
  ///@{
  /** \brief All observations, without poses.
   * \throws BadArgumentException if there are none */
  ObservationSequence
  observations() const
  {
    return files_.empty() ? ObservationSequence(clouds_) : ObservationSequence(files_);
  }

  /** \brief Number of observations that a fault has left out. */
  std::size_t
  missing() const
  {
    return arrived_ - consolidated_.size();
  }

  const std::vector<ConsolidatedObservation>&
  consolidated() const
  {
    return consolidated_;
  }

  OdometryRun&
  odometry()
  {
    return odometry_;
  }
  ///@}

private:
  using Clock = std::chrono::steady_clock;

  struct Item {
    std::optional<DisparityFusion> shots;
    std::shared_ptr<const PointCloudFile> cloud;
    std::optional<Eigen::Isometry3d> T_map_camera;
    std::string name;
    Clock::time_point complete = Clock::now();
  };

  void
  push(Item item);

  void
  work();

  void
  process(Item& item);

  void
  keep(const std::string& name, const std::shared_ptr<const PointCloudFile>& cloud);

  void
  addToProvisionalMap();

  void
  tellProvisional(std::shared_ptr<const CompactMap> map);

  MappingState
  state() const;

  void
  tell(const MappingState& state) const;

  Steps steps_;
  OdometryRun odometry_;
  std::vector<std::string> files_;
  std::vector<std::shared_ptr<const PointCloudFile>> clouds_; ///< without files only
  std::vector<ConsolidatedObservation> consolidated_;

  mutable std::mutex mutex_; ///< of all below, and of what was processed
  std::condition_variable changed_;
  std::deque<Item> waiting_; ///< the first one is being processed
  std::shared_ptr<const PointCloudFile> newest_;
  std::vector<std::optional<Eigen::Isometry3d>> poses_;
  std::shared_ptr<const CompactMap> provisional_map_;
  std::size_t arrived_ = 0;
  bool ends_ = false; ///< no observation follows
  bool is_stopped_ = false;
  bool is_partial_ = false; ///< \ref keepProcessed was called
  std::exception_ptr fault_;
  std::unique_ptr<ProvisionalMapping> provisional_; ///< null if it is not told
  std::thread worker_;
};

} // namespace pcl::acmap
