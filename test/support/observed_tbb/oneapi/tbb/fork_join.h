#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace oneapi::tbb::observed {

/** \brief Number of threads that may still be started. */
struct Arena {
  explicit Arena(int threads)
  : concurrency(threads)
  , spare(threads - 1)
  {}

  const int concurrency;
  std::atomic<int> spare;
};

inline thread_local Arena* entered = nullptr;

inline Arena&
arena()
{
  static Arena outermost(4);
  return entered ? *entered : outermost;
}

inline bool
takeThread(Arena& arena)
{
  int spare = arena.spare.load(std::memory_order_relaxed);
  while (spare > 0)
    if (arena.spare.compare_exchange_weak(spare, spare - 1, std::memory_order_relaxed))
      return true;
  return false;
}

/** \brief Runs work () in this thread and in up to \a maximum - 1 others, and waits for
 * all; rethrows the first exception. */
template <typename Work>
void
fork(std::size_t maximum, const Work& work)
{
  Arena& here = arena();
  std::mutex mutex;
  std::exception_ptr fault;
  const auto guarded = [&] {
    try {
      work();
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!fault)
        fault = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  while (threads.size() + 1 < maximum && takeThread(here))
    threads.emplace_back([&] {
      entered = &here;
      guarded();
    });
  guarded();
  for (std::thread& thread : threads)
    thread.join();
  here.spare.fetch_add(static_cast<int>(threads.size()), std::memory_order_relaxed);
  if (fault)
    std::rethrow_exception(fault);
}

} // namespace oneapi::tbb::observed
