#include "unfinished_file.h"

#include <pcl/core/impl/hidden_folder.h>

#include <filesystem>

namespace pcl::acmap::test {

namespace {

namespace fs = std::filesystem;

bool
isHiddenIn(const fs::path& place, const fs::path& file)
{
  std::error_code error; // files can appear and disappear meanwhile
  for (fs::directory_iterator entry(place, error), end; !error && entry != end;
       entry.increment(error))
    if (isHiddenFolderName(entry->path().filename().string()) &&
        fs::exists(entry->path() / file, error))
      return true;
  return false;
}

} // namespace

bool
isUnfinished(const std::string& folder, const std::string& name)
{
  const fs::path path(folder);
  return isHiddenIn(path, name) ||
         isHiddenIn(path.parent_path(), path.filename() / name);
}

} // namespace pcl::acmap::test
