#include "small_disk.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

constexpr std::size_t page = 4096;

/** \brief Makes this process the superuser of new user and mount namespaces. */
bool
becomeSuperuser()
{
  const std::string user = std::to_string(geteuid());
  const std::string group = std::to_string(getegid());
  if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0)
    return false;
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << "0 " + user + " 1";
  std::ofstream("/proc/self/gid_map") << "0 " + group + " 1";
  return geteuid() == 0;
}

bool
takeMounts()
{
  const bool has_own = geteuid() == 0 ? unshare(CLONE_NEWNS) == 0 : becomeSuperuser();
  return has_own && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

} // namespace

bool
SmallDisk::isAllowed()
{
  static const bool is_allowed = takeMounts();
  return is_allowed;
}

SmallDisk::SmallDisk(const std::string& folder, std::size_t bytes)
: folder_(folder)
{
  const std::string size = "size=" + std::to_string(bytes);
  if (!isAllowed() || mount("none", folder.c_str(), "tmpfs", 0, size.c_str()) != 0)
    throw std::runtime_error("no disk could be mounted");
}

SmallDisk::~SmallDisk()
{
  umount2(folder_.c_str(), MNT_DETACH);
}

void
SmallDisk::fill(std::size_t pages_left) const
{
  const std::string ballast = folder_ + "/ballast";
  const int file = open(ballast.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const std::string bytes(page, 'x');
  off_t length = 0;
  while (write(file, bytes.data(), page) == static_cast<ssize_t>(page))
    length += page;
  length -= static_cast<off_t>(pages_left * page);
  if (length < 0 || ftruncate(file, length) != 0)
    throw std::runtime_error(ballast + " does not fill the disk");
  close(file);
}

void
SmallDisk::makeReadOnly() const
{
  if (mount("none", folder_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) != 0)
    throw std::runtime_error(folder_ + " could not be made read-only");
}

} // namespace pcl::acmap::test
