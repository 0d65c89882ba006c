#include "memory.h"

#include "exit_code.h"

#include <sys/resource.h>

#include <fstream>
#include <limits>
#include <sstream>

namespace pcl::acmap {
namespace {

/** \brief Bytes a process could still get; the largest number where that is unknown. */
std::size_t
availableMemory()
{
  std::ifstream lines("/proc/meminfo");
  for (std::string name, rest; lines >> name; std::getline(lines, rest)) {
    std::size_t kilobytes = 0;
    if (name == "MemAvailable:" && lines >> kilobytes)
      return kilobytes * 1024;
  }
  return std::numeric_limits<std::size_t>::max();
}

} // namespace

std::size_t
peakMemory()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void
requireMemory(std::size_t bytes, const std::string& work)
{
  const std::size_t available = availableMemory();
  if (bytes <= available)
    return;
  std::ostringstream text;
  text.precision(3);
  text << work << " needs about " << static_cast<double>(bytes) / 1e9
       << " GB of memory, this machine has " << static_cast<double>(available) / 1e9
       << " GB left";
  throw MemoryRefused(text.str());
}

} // namespace pcl::acmap
