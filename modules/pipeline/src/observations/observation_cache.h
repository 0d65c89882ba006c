#pragma once

#include <pcl/core/point_cloud_file.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace pcl::acmap {

/** \brief Keeps files of a sequence in memory, up to a number of bytes.
 *
 * Several stages read a sequence from its beginning to its end. The files that were
 * read first are therefore kept, and later ones are not: if they replaced the first
 * ones, none would be in memory when the next stage needs it. Thread-safe. */
class ObservationCache {
public:
  /** \brief Function that reads an observation from its path. Must be thread-safe. */
  using Reader =
      std::function<std::shared_ptr<const PointCloudFile>(const std::string& path)>;

  /** \param[in] reader may be empty if all clouds are given to \ref hold */
  explicit ObservationCache(Reader reader = {})
  : reader_(std::move(reader))
  {}

  /** \brief Reads an observation unless it is in memory; throws as the reader. */
  std::shared_ptr<const PointCloudFile>
  load(const std::string& path);

  /** \brief Keeps a cloud that has no file; it does not count for the limit. */
  void
  hold(const std::string& path, std::shared_ptr<const PointCloudFile> cloud);

  void
  setLimit(std::size_t bytes);

  /** \brief Number of files that were read. */
  std::size_t
  reads() const;

private:
  std::shared_ptr<const PointCloudFile>
  find(const std::string& path) const;

  Reader reader_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const PointCloudFile>> files_, held_;
  std::size_t limit_ = std::size_t{512} << 20;
  std::size_t bytes_ = 0;
  std::size_t reads_ = 0;
};

} // namespace pcl::acmap
