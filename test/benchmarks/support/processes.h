#pragma once

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace pcl::acmap::bench {

/** \brief CPU seconds of all child processes that have ended. */
inline double
childSeconds()
{
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/** \brief Writes a result completely; on failure writes nothing, which the parent
 * detects. */
template <typename Result, typename Function>
bool
answerParent(int pipe, const Function& function)
{
  try {
    const Result result = function();
    return ::write(pipe, &result, sizeof result) == static_cast<ssize_t>(sizeof result);
  }
  catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return false;
  }
}

/** \brief Runs a function in a separate process and returns its result, so that the
 * memory of one run does not affect the next one. Must be called before any thread is
 * started: threads do not survive a fork, and a pool would wait for them.
 * \throws std::runtime_error when the child returned nothing */
template <typename Function>
auto
runInChild(const Function& function)
{
  using Result = decltype(function());
  static_assert(std::is_trivially_copyable_v<Result>);
  int ends[2];
  if (::pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child < 0)
    throw std::runtime_error("no child process");
  if (child == 0)
    ::_exit(answerParent<Result>(ends[1], function) ? 0 : 1);
  ::close(ends[1]);
  Result result;
  const ssize_t bytes = ::read(ends[0], &result, sizeof result);
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  if (bytes != static_cast<ssize_t>(sizeof result))
    throw std::runtime_error("a child process gave nothing");
  return result;
}

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
