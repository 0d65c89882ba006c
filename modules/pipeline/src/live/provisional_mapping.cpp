#include "live/provisional_mapping.h"

#include <pcl/conversions.h>
#include <pcl/pipeline/plane_mapping.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace pcl::acmap {

namespace {

/** The points of all observations with a pose in the frame of the map.
 * \param[out] viewpoints of these observations */
PointCloud<PointXYZRGBNormalView>::Ptr
mergedSoFar(const ObservationsSoFar& observations,
            std::vector<Eigen::Vector3f>& viewpoints)
{
  const PointCloud<PointXYZRGBNormalView>::Ptr merged(
      new PointCloud<PointXYZRGBNormalView>);
  for (std::size_t i = 0; i < observations.clouds.size(); ++i) {
    const auto& pose = observations.poses[i];
    if (!pose)
      continue;
    const Eigen::Isometry3f T_map_camera = pose->cast<float>();
    PointXYZRGBNormalView point;
    point.view = static_cast<std::int32_t>(viewpoints.size());
    viewpoints.push_back(T_map_camera.translation());
    for (const PointNormal& seen : *observations.clouds[i]) {
      point.getVector3fMap() = T_map_camera * seen.getVector3fMap();
      merged->push_back(point);
    }
  }
  return merged;
}

/** \throws what PlaneMapping does */
CompactMap
provisionalMap(const ObservationsSoFar& observations, ProgressCallback goes_on)
{
  constexpr double voxel = 0.1; // metres, wider than the steps of the odometry's drift
  std::vector<Eigen::Vector3f> viewpoints;
  PlaneMapping planes;
  planes.setInputCloud(mergedSoFar(observations, viewpoints));
  planes.setViewpoints(viewpoints);
  planes.setDepthSensor(DepthSensor::Laser); // in space
  planes.setConsolidationPolicy(ConsolidationPolicy::Always);
  PlaneMapping::Consolidation consolidation;
  consolidation.setVoxelSize(voxel);
  planes.setConsolidation(consolidation);
  planes.setNumberOfThreads(1);
  planes.setProgressCallback(std::move(goes_on));
  MappedPlanes found;
  planes.compute(found);
  CompactMap map;
  map.planes = std::move(found.planes);
  for (std::size_t i = 0; i < observations.poses.size(); ++i)
    if (observations.poses[i]) {
      map.trajectory.stamps.push_back(static_cast<double>(i));
      map.trajectory.poses.push_back(*observations.poses[i]);
    }
  return map;
}

} // namespace

ProvisionalMapping::ProvisionalMapping(double interval, Callback callback)
: interval_(interval)
, callback_(std::move(callback))
, worker_([this] { work(); })
{}

ProvisionalMapping::~ProvisionalMapping()
{
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

void
ProvisionalMapping::update(ObservationsSoFar observations)
{
  const std::lock_guard lock(mutex_);
  next_ = std::move(observations);
  changed_.notify_all();
}

void
ProvisionalMapping::work()
{
  using Clock = std::chrono::steady_clock;
  constexpr double share = 0.2; // of the time, at most
  Clock::time_point due = Clock::now();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_stopped_ || next_; });
    changed_.wait_until(lock, due, [this] { return is_stopped_.load(); });
    if (is_stopped_)
      return;
    const ObservationsSoFar observations = *std::exchange(next_, std::nullopt);
    lock.unlock();
    const Clock::time_point begin = Clock::now();
    try {
      const auto map = std::make_shared<const CompactMap>(provisionalMap(
          observations, [this](double, const std::string&) { return !is_stopped_; }));
      callback_(map);
    }
    catch (const PCLException&) {
      // These observations have no provisional map; the map at the end tells why.
    }
    const std::chrono::duration<double> took = Clock::now() - begin;
    due = begin + std::chrono::duration_cast<Clock::duration>(
                      std::max(std::chrono::duration<double>(interval_), took / share));
    lock.lock();
  }
}

} // namespace pcl::acmap
