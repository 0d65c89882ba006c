#include "observation_cache.h"

#include <pcl/core/scaled_cloud.h>

namespace pcl::acmap {

std::shared_ptr<const PointCloudFile>
ObservationCache::find(const std::string& path) const
{
  const std::lock_guard lock(mutex_);
  const auto found = files_.find(path);
  return found == files_.end() ? nullptr : found->second;
}

std::shared_ptr<const PointCloudFile>
ObservationCache::load(const std::string& path, double scale)
{
  if (std::shared_ptr<const PointCloudFile> kept = find(path))
    return kept;
  auto file = std::make_shared<const PointCloudFile>(loadScaledCloud(path, scale));
  const std::lock_guard lock(mutex_);
  ++reads_;
  const std::size_t bytes = file->cloud.data.size();
  if (bytes <= limit_ && bytes_ <= limit_ - bytes && files_.emplace(path, file).second)
    bytes_ += bytes;
  return file;
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
