#include "output_target.h"

#include "exit_code.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>
#include <pcl/pipeline/observation_files.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {
namespace fs = std::filesystem;
namespace {

std::string
listOf(const std::vector<std::string>& endings)
{
  std::string list;
  for (const std::string& ending : endings)
    list += (list.empty() ? "" : " or ") + ending;
  return list;
}

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

std::string
replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

} // namespace

std::string
endingOf(const std::string& path)
{
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

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
    throw OutputFileException(path + ": unknown ending, " + listOf(endings) +
                              " is needed");
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

OutputGroup::Entry::Entry(const std::string& path)
: path(path)
, target(followLinks(path))
, hidden(fs::path(target).parent_path(), fs::path(target).filename().string(), path)
, place((hidden.path() / fs::path(target).filename()).string())
{}

void
OutputGroup::write(const std::string& path,
                   const std::function<void(const std::string& place)>& save)
{
  std::error_code error;
  if (fs::exists(path, error) && access(path.c_str(), W_OK) != 0)
    throw OutputFileException(path + ": " + std::strerror(errno));
  const Entry& entry = entries_.emplace_back(path);
  try {
    save(entry.place);
  }
  catch (const OutputFileException& e) {
    throw OutputFileException(
        replaced(replaced(e.what(), entry.place, path), entry.target, path));
  }
}

void
OutputGroup::commit()
{
  for (const Entry& entry : entries_) {
    std::error_code error;
    const fs::file_status old = fs::status(entry.target, error);
    if (fs::exists(old))
      fs::permissions(entry.place, old.permissions(), error);
    fs::rename(entry.place, entry.target, error);
    if (error)
      throw OutputFileException(entry.path + ": " + error.message());
  }
  entries_.clear();
}

} // namespace pcl::acmap
