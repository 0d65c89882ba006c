#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <system_error>

namespace pcl::acmap {

/** \brief Names of the entries of a folder; none, or some, if it cannot be listed. */
inline std::set<std::string>
namesOfFolder(const std::filesystem::path& folder)
{
  namespace fs = std::filesystem;
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    names.insert(entry->path().filename().string());
  return names;
}

} // namespace pcl::acmap
