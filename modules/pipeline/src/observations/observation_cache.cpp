#include "observations/observation_cache.h"

namespace pcl::acmap {

std::shared_ptr<const PointCloudFile>
ObservationCache::find(const std::string& path) const
{
  const std::lock_guard lock(mutex_);
  for (const auto* clouds : {&held_, &files_})
    if (const auto found = clouds->find(path); found != clouds->end())
      return found->second;
  return nullptr;
}

std::shared_ptr<const PointCloudFile>
ObservationCache::load(const std::string& path)
{
  if (std::shared_ptr<const PointCloudFile> kept = find(path))
    return kept;
  std::shared_ptr<const PointCloudFile> file = reader_(path);
  const std::lock_guard lock(mutex_);
  ++reads_;
  const std::size_t bytes = file->cloud.data.size();
  if (bytes <= limit_ && bytes_ <= limit_ - bytes && files_.emplace(path, file).second)
    bytes_ += bytes;
  return file;
}

void
ObservationCache::hold(const std::string& path,
                       std::shared_ptr<const PointCloudFile> cloud)
{
  const std::lock_guard lock(mutex_);
  held_[path] = std::move(cloud);
}

void
ObservationCache::setLimit(std::size_t bytes)
{
  const std::lock_guard lock(mutex_);
  limit_ = bytes;
  while (bytes_ > limit_) {
    bytes_ -= files_.rbegin()->second->cloud.data.size();
    files_.erase(std::prev(files_.end()));
  }
}

std::size_t
ObservationCache::reads() const
{
  const std::lock_guard lock(mutex_);
  return reads_;
}

} // namespace pcl::acmap
