#pragma once

#include <pcl/core/point_cloud_file.h>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace pcl::acmap {

/** \brief Files of a sequence that stay in memory, up to a number of bytes.
 *
 * Stages read a sequence from its beginning to its end, again and again. What was read
 * first is therefore kept, and later files are not: had they replaced it, none would be
 * there when the next stage asks for it. May be used from several threads. */
class ObservationCache {
public:
  /** \brief Reads a file unless it is kept.
   * \param[in] scale metres in a unit of the file
   * \throws InputFileException as \ref pcl::loadPointCloud */
  std::shared_ptr<const PointCloudFile>
  load(const std::string& path, double scale);

  /** \brief Keeps a cloud that no file holds, beside the limit. */
  void
  hold(const std::string& path, std::shared_ptr<const PointCloudFile> cloud);

  void
  setLimit(std::size_t bytes);

  /** \brief Number of files that were read so far. */
  std::size_t
  reads() const;

private:
  std::shared_ptr<const PointCloudFile>
  find(const std::string& path) const;

  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const PointCloudFile>> files_, held_;
  std::size_t limit_ = std::size_t{512} << 20;
  std::size_t bytes_ = 0;
  std::size_t reads_ = 0;
};

} // namespace pcl::acmap
