#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>

#include <algorithm>
#include <new>

namespace pcl::acmap {

namespace {

/** Does the same as operator new without memory: the new-handler may free the memory
 * that stack unwinding needs. */
[[noreturn]] void
failForMemory()
{
  if (const std::new_handler handler = std::get_new_handler())
    handler();
  throw std::bad_alloc();
}

} // namespace

std::vector<std::filesystem::path>
folderEntries(const std::string& folder)
{
  namespace fs = std::filesystem;
  std::vector<fs::path> entries;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    entries.push_back(entry->path());
  if (error == std::errc::not_enough_memory)
    failForMemory();
  if (error)
    throw InputFileException(folder + ": " + error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

} // namespace pcl::acmap
