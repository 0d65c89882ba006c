#include "threads/scratch_pages.h"

#include <pcl/core/impl/large_memory.h>

#include <sys/mman.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <cstdint>
#include <new>

namespace pcl::acmap {

void
adviseLargePages(void* begin, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t page = 4096;
  constexpr std::size_t worthwhile = std::size_t{4} << 20;
  if (bytes < worthwhile || isInScratch(begin))
    return;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / page * page;
  // A system without large pages refuses, and nothing is lost.
  ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#else
  static_cast<void>(begin);
  static_cast<void>(bytes);
#endif
}

void
returnFreeMemory()
{
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

namespace {

constexpr std::align_val_t line_of_cache{64};

} // namespace

void*
allocateFromSystem(std::size_t bytes)
{
  if (bytes < worth_pages)
    return ::operator new(bytes, line_of_cache);
  if (void* const memory = mapScratch(bytes))
    return memory;
  void* const memory = ::mmap(
      nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw std::bad_alloc();
  return memory;
}

void
returnToSystem(void* memory, std::size_t bytes)
{
  if (bytes < worth_pages)
    ::operator delete(memory, line_of_cache);
  else
    unmapLarge(memory, bytes);
}

} // namespace pcl::acmap
