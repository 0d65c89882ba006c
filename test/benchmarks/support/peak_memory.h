#pragma once

#include <malloc.h>

#include <cstddef>
#include <fstream>
#include <string>

namespace pcl::acmap::bench {

/** \brief Peak memory of the process from now on, in addition to its current memory.
 * Linux. */
class PeakMemory {
public:
  PeakMemory()
  {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // resets the peak
    begin_ = statusBytes("VmRSS:");
  }

  std::size_t
  bytes() const
  {
    return statusBytes("VmHWM:") - begin_;
  }

private:
  static std::size_t
  statusBytes(const std::string& key)
  {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (word == key) {
        std::size_t kilobytes = 0;
        status >> kilobytes;
        return 1024 * kilobytes;
      }
    return 0;
  }

  std::size_t begin_ = 0;
};

} // namespace pcl::acmap::bench
