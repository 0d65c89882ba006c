// For programs under AddressSanitizer. Mesa's software renderer makes code as it runs, by
// LLVM, and what that code leaks has no name that a suppression could tell. A process
// that has drawn is not asked for leaks; all others are.
#include <link.h>

#include <cstddef>
#include <cstring>

namespace {

int
isCompiler(dl_phdr_info* library, std::size_t /*size*/, void* /*nothing*/)
{
  return std::strstr(library->dlpi_name, "libLLVM") != nullptr ? 1 : 0;
}

} // namespace

/** \brief Unloads nothing, or nobody could tell at exit who has drawn. */
extern "C" int
dlclose(void* /*library*/)
{
  return 0;
}

/** \brief LeakSanitizer asks before it looks. */
extern "C" int
__lsan_is_turned_off()
{
  return dl_iterate_phdr(isCompiler, nullptr);
}
