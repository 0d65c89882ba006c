#pragma once

#include <ctime>

namespace pcl::acmap::bench {

inline double
clockSeconds(clockid_t clock)
{
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/** \brief CPU seconds the calling thread has used: unlike wall time, hardly disturbed by
 * what else the machine does. */
inline double
threadSeconds()
{
  return clockSeconds(CLOCK_THREAD_CPUTIME_ID);
}

/** \brief CPU seconds all threads of the process have used. */
inline double
processSeconds()
{
  return clockSeconds(CLOCK_PROCESS_CPUTIME_ID);
}

} // namespace pcl::acmap::bench
