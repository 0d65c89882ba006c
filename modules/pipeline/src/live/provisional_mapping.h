#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/sequence_consolidation.h>

#include <Eigen/Geometry>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace pcl::acmap {

/** \brief What is known of the map so far. */
struct ObservationsSoFar {
  std::vector<PointCloud<PointNormal>::ConstPtr> clouds; ///< consolidated, sensor frame
  std::vector<std::optional<Eigen::Isometry3d>> poses;   ///< T_map_camera
};

/** \brief Computes the planes of the observations so far, again and again, in a thread of
 * its own that uses at most a fifth of a processor. */
class ProvisionalMapping {
public:
  using Callback = std::function<void(std::shared_ptr<const CompactMap>)>;

  /** \param[in] interval shortest time from one map to the next, seconds
   * \param[in] callback is called by the thread with each map */
  ProvisionalMapping(double interval, Callback callback);

  /** \brief Stops at once. */
  ~ProvisionalMapping();

  ProvisionalMapping(const ProvisionalMapping&) = delete;
  ProvisionalMapping&
  operator=(const ProvisionalMapping&) = delete;

  /** \brief Replaces what the next map is made of. */
  void
  update(ObservationsSoFar observations);

private:
  void
  work();

  double interval_;
  Callback callback_;
  std::atomic<bool> is_stopped_ = false;
  std::mutex mutex_; ///< of what follows
  std::condition_variable changed_;
  std::optional<ObservationsSoFar> next_;
  std::thread worker_;
};

} // namespace pcl::acmap
