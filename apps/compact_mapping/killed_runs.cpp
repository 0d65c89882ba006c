#include "killed_runs.h"

#include <csignal>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <vector>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** Whether a name is `.any.tmp-<process>-<number>`, as OutputFile and OutputFolder give. */
bool
isOfDeadProcess(const std::string& name)
{
  constexpr std::string_view mark = ".tmp-";
  const std::size_t at = name.rfind(mark);
  if (name.front() != '.' || at == std::string::npos)
    return false;
  const char* const end = name.data() + name.size();
  pid_t process = 0;
  std::uint64_t number = 0;
  const auto first = std::from_chars(name.data() + at + mark.size(), end, process);
  if (first.ec != std::errc() || process <= 0 || first.ptr == end || *first.ptr != '-')
    return false;
  const auto second = std::from_chars(first.ptr + 1, end, number);
  return second.ec == std::errc() && second.ptr == end && kill(process, 0) != 0 &&
         errno == ESRCH;
}

} // namespace

void
removeLeftovers(const std::string& folder)
{
  std::vector<fs::path> leftovers;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored))
    if (isOfDeadProcess(entry->path().filename().string()))
      leftovers.push_back(entry->path());
  for (const fs::path& path : leftovers)
    fs::remove_all(path, ignored);
}

} // namespace pcl::acmap
