#include "output_target.h"

#include "exit_code.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_files.h>

#include <CLI/StringTools.hpp>

#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace pcl::acmap {
namespace fs = std::filesystem;
namespace {

/** \brief Do two names, existing or not, refer to the same file? */
bool
sameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  if (fs::equivalent(a, b, error))
    return true;
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

void
requireFolder(const std::string& path)
{
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw OutputFileException(path + ": there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw OutputFileException(path + ": no permission to write into the folder " +
                              folder.string());
}

} // namespace

void
requireWritable(const std::string& path,
                const std::vector<std::string>& endings,
                const std::vector<std::string>& others)
{
  for (const std::string& other : others)
    if (!other.empty() && sameFile(path, other))
      throw UsageError(path + ": would replace another file of this run, " + other);
  std::error_code error;
  if (fs::is_directory(path, error))
    throw OutputFileException(path + ": is a folder, a file is needed");
  if (std::find(endings.begin(), endings.end(), endingOf(path)) == endings.end())
    throw OutputFileException(path + ": unknown ending, " +
                              CLI::detail::join(endings, " or ") + " is needed");
  requireFolder(path);
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw OutputFileException(path + ": is not a regular file");
}

void
requireNoneIn(const OutputFolder& folder,
              const std::function<bool(const std::string& name)>& is_ours)
{
  for (const std::string& name : folder.names())
    if (is_ours(name))
      throw OutputFileException(folder.name() + ": already holds " + name +
                                "; name an empty or a new folder");
}

void
requireNoSequence(const OutputFolder& folder, const std::vector<std::string>& more)
{
  requireNoneIn(folder, [&](const std::string& name) {
    return isSequenceName(name) || std::count(more.begin(), more.end(), name) > 0;
  });
}

} // namespace pcl::acmap
