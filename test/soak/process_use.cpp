#include "process_use.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <stdexcept>

#include <malloc.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ACMAP_SANITIZED
// GCC does not provide the header with this declaration.
extern "C" std::size_t
__sanitizer_get_current_allocated_bytes();
#endif

namespace pcl::acmap::test {
namespace {

std::ptrdiff_t
entriesIn(const char* folder)
{
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

#ifdef ACMAP_SANITIZED

void
measureMemory(ProcessUse& use)
{
  use.allocated =
      static_cast<std::ptrdiff_t>(__sanitizer_get_current_allocated_bytes());
}

#else

void
measureMemory(ProcessUse& use)
{
  malloc_trim(0);
  const auto heap = mallinfo2();
  use.allocated = static_cast<std::ptrdiff_t>(heap.uordblks + heap.hblkhd);

  std::ifstream file("/proc/self/statm");
  std::ptrdiff_t all = 0, resident = 0;
  if (!(file >> all >> resident))
    throw std::runtime_error("/proc/self/statm cannot be read");
  use.resident = resident * sysconf(_SC_PAGESIZE);
}

#endif

} // namespace

ProcessUse
currentUse()
{
  ProcessUse use;
  use.files = entriesIn("/proc/self/fd");
  use.threads = entriesIn("/proc/self/task");
  measureMemory(use);
  return use;
}

ProcessUse
operator-(const ProcessUse& after, const ProcessUse& before)
{
  return {after.allocated - before.allocated,
          after.resident - before.resident,
          after.files - before.files,
          after.threads - before.threads};
}

std::ostream&
operator<<(std::ostream& stream, const ProcessUse& growth)
{
  return stream << "allocated " << growth.allocated / 1024 << " KB, resident "
                << growth.resident / 1024 << " KB, files " << growth.files
                << ", threads " << growth.threads;
}

} // namespace pcl::acmap::test
