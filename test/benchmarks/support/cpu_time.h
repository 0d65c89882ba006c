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

/** \brief CPU seconds used by the calling thread; unlike wall time, other load of the
 * machine hardly affects them. */
inline double
threadSeconds()
{
  return clockSeconds(CLOCK_THREAD_CPUTIME_ID);
}

/** \brief CPU seconds used by all threads of the process. */
inline double
processSeconds()
{
  return clockSeconds(CLOCK_PROCESS_CPUTIME_ID);
}

} // namespace pcl::acmap::bench
