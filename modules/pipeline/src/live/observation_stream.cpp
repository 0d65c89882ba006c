#include "live/observation_stream.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_files.h>

#include <filesystem>
#include <utility>

namespace pcl::acmap {

std::shared_ptr<const PointCloudFile>
projectFused(DisparityFusion& fusion, DisparityBackProjection& projection)
{
  MatchedDisparity disparity;
  fusion.fuse(disparity);
  PointCloud<PointXYZRGBSigma> cloud;
  projection.project(disparity, fusion.getColor(), cloud);
  const auto file = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(cloud, file->cloud);
  file->sensor_origin = cloud.sensor_origin_.head<3>();
  file->sensor_orientation = cloud.sensor_orientation_;
  return file;
}

ObservationStream::ObservationStream(Steps steps)
: steps_(std::move(steps))
, odometry_(steps_.odometry)
, provisional_(steps_.callback && steps_.provisional_interval > 0
                   ? std::make_unique<ProvisionalMapping>(
                         steps_.provisional_interval,
                         [this](const auto& map) { tellProvisional(map); })
                   : nullptr)
, worker_([this] { work(); })
{}

ObservationStream::~ObservationStream()
{
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  changed_.notify_all();
  if (worker_.joinable())
    worker_.join();
}

void
ObservationStream::add(DisparityFusion shots)
{
  push({std::move(shots), nullptr, std::nullopt, {}});
}

void
ObservationStream::add(std::shared_ptr<const PointCloudFile> cloud,
                       const std::optional<Eigen::Isometry3d>& T_map_camera,
                       const std::string& name)
{
  push({std::nullopt, std::move(cloud), T_map_camera, name});
}

std::size_t
ObservationStream::size() const
{
  const std::lock_guard lock(mutex_);
  return arrived_;
}

void
ObservationStream::push(Item item)
{
  std::unique_lock lock(mutex_);
  if (ends_)
    throw acmap::InitFailed("the map of the observations was computed: clear () begins "
                            "another one");
  const auto has_room = [this] {
    return fault_ || waiting_.size() < steps_.maximum_waiting;
  };
  if (!has_room()) {
    MappingState late = state();
    late.is_late = true;
    lock.unlock();
    tell(late);
    lock.lock();
    changed_.wait(lock, has_room);
  }
  if (fault_)
    std::rethrow_exception(fault_);
  waiting_.push_back(std::move(item));
  ++arrived_;
  changed_.notify_all();
}

void
ObservationStream::finish()
{
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  if (worker_.joinable())
    worker_.join();
  provisional_.reset(); // the map itself needs the processors now
  if (fault_ && (!is_partial_ || consolidated_.empty()))
    std::rethrow_exception(fault_);
}

void
ObservationStream::keepProcessed()
{
  const std::lock_guard lock(mutex_);
  is_partial_ = true;
}

void
ObservationStream::work()
{
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_stopped_ || ends_ || !waiting_.empty(); });
    if (is_stopped_ || waiting_.empty())
      return;
    Item& item = waiting_.front(); // push () leaves it where it is
    lock.unlock();
    try {
      process(item);
      lock.lock();
      waiting_.pop_front();
      const MappingState now = state();
      lock.unlock();
      tell(now);
      lock.lock();
    }
    catch (...) {
      if (!lock.owns_lock())
        lock.lock();
      fault_ = std::current_exception();
      changed_.notify_all();
      return;
    }
    changed_.notify_all();
  }
}

void
ObservationStream::process(Item& item)
{
  const std::size_t index = consolidated_.size();
  const std::string name = item.name.empty() ? observationName(index) : item.name;
  const ProgressCallback goes_on = [this](double, const std::string&) {
    const std::lock_guard lock(mutex_);
    return !is_stopped_;
  };
  if (item.shots) {
    item.shots->setProgressCallback(goes_on);
    item.cloud = projectFused(*item.shots, steps_.projection);
  }
  odometry_.setProgressCallback(goes_on);
  if (!item.T_map_camera)
    odometry_.add(odometryView(index, item.cloud), name);
  ConsolidatedObservation consolidated;
  if (steps_.consolidates)
    consolidated = steps_.consolidation.consolidate(*item.cloud, name);
  if (steps_.keeps_clouds)
    keep(name, item.cloud);
  {
    const std::lock_guard lock(mutex_);
    newest_ = item.cloud;
    consolidated_.push_back(std::move(consolidated));
    if (item.T_map_camera)
      poses_.push_back(item.T_map_camera);
    else
      poses_ = odometry_.result().poses;
  }
  if (provisional_)
    addToProvisionalMap();
}

void
ObservationStream::addToProvisionalMap()
{
  ObservationsSoFar so_far;
  for (const ConsolidatedObservation& observation : consolidated_)
    so_far.clouds.push_back(observation.cloud);
  so_far.poses = poses_;
  provisional_->update(std::move(so_far));
}

void
ObservationStream::tellProvisional(std::shared_ptr<const CompactMap> map)
{
  MappingState now;
  {
    const std::lock_guard lock(mutex_);
    provisional_map_ = std::move(map);
    now = state();
  }
  tell(now);
}

void
ObservationStream::keep(const std::string& name,
                        const std::shared_ptr<const PointCloudFile>& cloud)
{
  if (steps_.folder.empty()) {
    clouds_.push_back(cloud);
    return;
  }
  const std::string file = (std::filesystem::path(steps_.folder) / name).string();
  saveObservation(file, cloud->cloud, Eigen::Isometry3d::Identity());
  files_.push_back(file);
}

MappingState
ObservationStream::state() const
{
  MappingState now;
  now.arrived = arrived_;
  now.processed = consolidated_.size();
  if (!waiting_.empty())
    now.lag =
        std::chrono::duration<double>(Clock::now() - waiting_.front().complete).count();
  now.newest = newest_;
  now.poses = poses_;
  now.provisional = provisional_map_;
  return now;
}

void
ObservationStream::tell(const MappingState& state) const
{
  if (steps_.callback)
    steps_.callback(state);
}

} // namespace pcl::acmap
