#include "memory.h"

#include "exit_code.h"

#include <pcl/core/parallel.h>

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <limits>
#include <new>
#include <sstream>
#include <thread>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ACMAP_SANITIZED_MEMORY
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ACMAP_SANITIZED_MEMORY
#endif

namespace pcl::acmap {
namespace {

constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();

/** \brief Small blocks may exceed the limit by this amount: some are allocated in
 * destructors (those of nlohmann-json), where a refusal would end the process. Large
 * blocks are refused. */
constexpr std::size_t for_small_blocks = std::size_t{1} << 20;

std::size_t memory_limit = 0;
std::size_t memory_before = 0; // when the limit was set

#ifdef ACMAP_SANITIZED_MEMORY
constexpr bool can_refuse = false;
#else
constexpr bool can_refuse = true;
#endif

/** \brief Reads a row of one of the kernel's memory tables, in bytes. */
std::size_t
rowOf(const char* table, const std::string& row)
{
  std::ifstream lines(table);
  for (std::string name, rest; lines >> name; std::getline(lines, rest)) {
    std::size_t kilobytes = 0;
    if (name == row && lines >> kilobytes)
      return kilobytes * 1024;
  }
  return unknown;
}

/** \brief Memory that counts for the limit: private writable memory of this process. */
std::size_t
ownMemory()
{
  return rowOf("/proc/self/status", "VmData:");
}

void
refuseBeyond(rlim_t bytes)
{
  rlimit both = {};
  if (!can_refuse || getrlimit(RLIMIT_DATA, &both) != 0)
    return;
  both.rlim_cur = std::min(bytes, both.rlim_max);
  setrlimit(RLIMIT_DATA, &both);
}

void
startThreads(unsigned threads)
{
  using Clock = std::chrono::steady_clock;
  withThreads(threads, [] {
    const int all = oneapi::tbb::this_task_arena::max_concurrency();
    // on a busy machine; a thread that starts later ends the process if it gets no
    // memory
    const auto deadline = Clock::now() + std::chrono::seconds(10);
    std::atomic<int> there = 0;
    // each task keeps its thread busy until all threads have started
    oneapi::tbb::parallel_for(0, all, [&](int) {
      ++there;
      while (there < all && Clock::now() < deadline)
        std::this_thread::yield();
    });
  });
}

/** The first refusal lifts the limit: the cleanup after the run needs memory, too. */
void
refuseOnce()
{
  refuseBeyond(RLIM_INFINITY);
  throw std::bad_alloc();
}

rlim_t
largestOwnMemory()
{
  const std::size_t besides = memory_before + for_small_blocks;
  return memory_limit > unknown - besides ? RLIM_INFINITY : besides + memory_limit;
}

std::size_t
leftByLimit()
{
  if (!memory_limit)
    return unknown;
  if (!can_refuse) // and the memory in use is not meaningful
    return memory_limit;
  const std::size_t taken = std::max(ownMemory(), memory_before) - memory_before;
  return memory_limit - std::min(memory_limit, taken);
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
limitMemory(std::size_t bytes, unsigned threads)
{
  if (bytes == 0)
    return;
  startThreads(threads);
  memory_before = ownMemory();
  memory_limit = bytes;
  std::set_new_handler(refuseOnce);
  if (memory_before != unknown)
    refuseBeyond(largestOwnMemory());
}

std::size_t
memoryLimit()
{
  return memory_limit;
}

UnlimitedMemory::UnlimitedMemory()
: before_(ownMemory())
{
  if (memory_limit)
    refuseBeyond(RLIM_INFINITY);
}

UnlimitedMemory::~UnlimitedMemory()
{
  memory_before += std::max(ownMemory(), before_) - before_;
  if (memory_limit)
    refuseBeyond(largestOwnMemory());
}

void
requireMemory(std::size_t bytes, const std::string& work)
{
  const std::size_t left = leftByLimit();
  const std::size_t available = rowOf("/proc/meminfo", "MemAvailable:");
  if (bytes <= std::min(left, available))
    return;
  throw MemoryRefused(work + " needs about " + gigabytes(bytes) + " of memory, " +
                      (left < available
                           ? "--memory-limit leaves " + gigabytes(left)
                           : "this machine has " + gigabytes(available) + " left"));
}

std::string
gigabytes(std::size_t bytes)
{
  std::ostringstream text;
  text.precision(3);
  text << static_cast<double>(bytes) / 1e9 << " GB";
  return text.str();
}

} // namespace pcl::acmap
