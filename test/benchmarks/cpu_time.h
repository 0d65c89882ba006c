#pragma once

#include <ctime>

namespace pcl::acmap::bench {

/** \brief CPU seconds the calling thread has used: unlike wall time, hardly disturbed by
 * what else the machine does. */
inline double
threadSeconds()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace pcl::acmap::bench
