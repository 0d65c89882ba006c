#include <pcl/core/process_memory.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/size_text.h>

#include <sys/resource.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <limits>
#include <mutex>
#include <new>

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

constexpr std::size_t unknown_memory = std::numeric_limits<std::size_t>::max();

/** \brief Small blocks may exceed the limit by this amount: some are allocated in
 * destructors (those of nlohmann-json), where a refusal would end the process. Large
 * blocks are refused. */
constexpr std::size_t for_small_blocks = std::size_t{1} << 20;

constexpr std::size_t min_resident_scratch = std::size_t{16} << 20;

std::size_t memory_limit = 0;
std::size_t memory_before = 0; // when the limit was set

#ifdef ACMAP_SANITIZED_MEMORY
constexpr bool can_refuse = false;
#else
constexpr bool can_refuse = true;
#endif

/** \brief Reads a row of one of the kernel's memory tables, in bytes. */
std::size_t
memoryInTable(const char* table, const std::string& row)
{
  std::ifstream lines(table);
  for (std::string name, rest; lines >> name; std::getline(lines, rest)) {
    std::size_t kilobytes = 0;
    if (name == row && lines >> kilobytes)
      return kilobytes * 1024;
  }
  return unknown_memory;
}

/** \brief Memory that counts for the limit: private writable memory of this process. */
std::size_t
ownMemory()
{
  return memoryInTable("/proc/self/status", "VmData:");
}

void
limitOwnMemory(rlim_t bytes)
{
  rlimit both = {};
  if (!can_refuse || getrlimit(RLIMIT_DATA, &both) != 0)
    return;
  both.rlim_cur = std::min(bytes, both.rlim_max);
  setrlimit(RLIMIT_DATA, &both);
}

/** \brief Sets the limit in addition to the memory that does not count for it. */
void
limitAgain()
{
  const std::size_t besides = memory_before + for_small_blocks;
  limitOwnMemory(memory_limit > unknown_memory - besides ? RLIM_INFINITY
                                                         : besides + memory_limit);
}

/** \brief Starts the worker threads: each waits until all have started. */
void
startThreads(unsigned threads)
{
  withThreads(threads, [] {
    // on a busy machine; a thread that starts later ends the process if it gets no
    // memory
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    const int all = oneapi::tbb::this_task_arena::max_concurrency();
    int started = 0;
    std::mutex mutex;
    std::condition_variable all_started;
    oneapi::tbb::parallel_for(0, all, [&](int) {
      std::unique_lock<std::mutex> lock(mutex);
      if (++started == all)
        all_started.notify_all();
      all_started.wait_until(lock, deadline, [&] { return started == all; });
    });
  });
}

/** \brief Lets the heap return each block of this size or more as soon as it is released.
 * It would otherwise keep ever larger ones for later, with what lies between them, and all
 * of that counts for the limit. */
void
returnBlocksAtOnce()
{
#ifdef __GLIBC__
  constexpr int from = 128 * 1024; // bytes
  mallopt(M_MMAP_THRESHOLD, from);
#endif
}

std::size_t
leftByLimit()
{
  if (!memory_limit)
    return unknown_memory;
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
  returnBlocksAtOnce();
  startThreads(threads);
  memory_before = ownMemory();
  memory_limit = bytes;
  // the first refusal lifts the limit: the cleanup after the run needs memory, too
  std::set_new_handler([] {
    limitOwnMemory(RLIM_INFINITY);
    throw std::bad_alloc();
  });
  if (memory_before != unknown_memory)
    limitAgain();
}

std::size_t
memoryLimit()
{
  return memory_limit;
}

std::size_t
residentScratch()
{
  constexpr std::size_t usual = std::size_t{256} << 20;
  return memory_limit == 0 ? usual
                           : std::clamp(memory_limit / 4, min_resident_scratch, usual);
}

std::size_t
availableMemory()
{
  return std::min(leftByLimit(), memoryInTable("/proc/meminfo", "MemAvailable:"));
}

UnlimitedMemory::UnlimitedMemory()
: before_(ownMemory())
{
  if (memory_limit)
    limitOwnMemory(RLIM_INFINITY);
}

UnlimitedMemory::~UnlimitedMemory()
{
  memory_before += std::max(ownMemory(), before_) - before_;
  if (memory_limit)
    limitAgain();
}

void
requireMemory(std::size_t bytes, const std::string& work)
{
  const std::size_t left = leftByLimit();
  const std::size_t available = memoryInTable("/proc/meminfo", "MemAvailable:");
  if (bytes <= std::min(left, available))
    return;
  throw MemoryLimitException(
      work + " needs about " + gigabytes(bytes) + " of memory, " +
      (left < available ? "--memory-limit leaves " + gigabytes(left)
                        : "this machine has " + gigabytes(available) + " left"));
}

std::string
gigabytes(std::size_t bytes)
{
  return shortNumber(static_cast<double>(bytes) / 1e9) + " GB";
}

} // namespace pcl::acmap
