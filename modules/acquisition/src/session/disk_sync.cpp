#include "disk_sync.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/hidden_folder.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {

namespace {

void
sync(const std::string& path, int flags)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | flags);
  const int fault = file >= 0 && ::fsync(file) == 0 ? 0 : errno;
  if (file >= 0)
    ::close(file);
  // Special files do not support fsync; some writable folders cannot be opened for
  // reading.
  if (fault != 0 && fault != EINVAL && fault != EACCES)
    throw OutputFileException(shownPath(path) + ": " + std::strerror(fault));
}

} // namespace

void
syncToDisk(const std::string& path)
{
  sync(path, 0);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  sync(folder.empty() ? "." : folder, O_DIRECTORY);
}

} // namespace pcl::acmap
