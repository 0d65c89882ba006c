// For programs under AddressSanitizer. Mesa's software renderer compiles code at run
// time with LLVM, and leaks in this code have no symbol that a suppression could name.
// So the leak check is disabled for processes that have drawn something.
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

/** \brief Never unloads a library, so that __lsan_is_turned_off still finds LLVM at
 * exit. */
extern "C" int
dlclose(void* /*library*/)
{
  return 0;
}

/** \brief Called by LeakSanitizer before its check. */
extern "C" int
__lsan_is_turned_off()
{
  return dl_iterate_phdr(isCompiler, nullptr);
}
