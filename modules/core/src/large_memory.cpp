#include <pcl/core/impl/large_memory.h>

#include <sys/mman.h>

#include <cstdint>

namespace pcl::acmap {

void
adviseLargePages(void* begin, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t page = 4096;
  constexpr std::size_t worthwhile = std::size_t{4} << 20;
  if (bytes < worthwhile)
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

} // namespace pcl::acmap
