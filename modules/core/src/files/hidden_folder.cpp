#include <pcl/core/exceptions.h>
#include <pcl/core/impl/hidden_folder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <vector>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

const std::string unfinished_mark = ".acmap-unfinished-";

/** Only a few processes write the same target at the same time. */
constexpr std::size_t max_leftovers = 8;

fs::path
numbered(const fs::path& parent, const std::string& name, std::size_t number)
{
  // keeps the whole name below the usual limit of 255
  constexpr std::size_t longest = 200;
  const std::string begin = name.empty() ? "" : "." + name.substr(0, longest);
  return parent / (begin + unfinished_mark + std::to_string(number));
}

int
openFolder(const fs::path& path)
{
  return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/** Returns true if an open folder is still the one with this name. */
bool
isStill(int folder, const fs::path& path)
{
  struct stat opened;
  struct stat named;
  return ::fstat(folder, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/** A process holds the lock of a folder while it removes it, so that no other process
 * can use it in the meantime. */
void
removeIfLeft(const fs::path& path)
{
  const int folder = openFolder(path);
  if (folder < 0)
    return;
  std::error_code ignored;
  if (::flock(folder, LOCK_EX | LOCK_NB) == 0 && isStill(folder, path))
    fs::remove_all(path, ignored);
  ::close(folder);
}

/** \return -1 if another process considered the new folder a leftover before it was
 * locked */
int
lockNew(const fs::path& path, const std::string& shown)
{
  const int folder = openFolder(path);
  if (folder < 0 && errno != ENOENT) {
    const std::string fault = std::strerror(errno);
    ::rmdir(path.c_str());
    throw OutputFileException(shown + ": " + fault);
  }
  if (folder < 0)
    return -1;
  ::flock(folder, LOCK_EX); // without support for locks, leftovers are kept
  if (isStill(folder, path))
    return folder;
  ::close(folder);
  return -1;
}

} // namespace

HiddenFolder::HiddenFolder(const fs::path& parent,
                           const std::string& name,
                           const std::string& shown)
{
  removeLeftoversOf(parent, name);
  for (std::size_t number = 0; lock_ < 0;) {
    path_ = numbered(parent, name, number);
    if (::mkdir(path_.c_str(), 0777) == 0)
      lock_ = lockNew(path_, shown);
    else if (errno == EEXIST)
      ++number;
    else
      throw OutputFileException(shown + ": " + std::strerror(errno));
  }
}

HiddenFolder::~HiddenFolder()
{
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  ::close(lock_);
}

bool
isHiddenFolderName(const std::string& name)
{
  const std::size_t at = name.rfind(unfinished_mark);
  if (at == std::string::npos || name.front() != '.')
    return false;
  const std::string number = name.substr(at + unfinished_mark.size());
  return !number.empty() &&
         std::all_of(number.begin(), number.end(), [](unsigned char letter) {
           return std::isdigit(letter);
         });
}

void
removeLeftoversIn(const std::string& folder)
{
  std::vector<fs::path> hidden;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored))
    if (isHiddenFolderName(entry->path().filename().string()))
      hidden.push_back(entry->path());
  for (const fs::path& path : hidden)
    removeIfLeft(path);
}

void
removeLeftoversOf(const fs::path& parent, const std::string& name)
{
  for (std::size_t number = 0; number < max_leftovers; ++number)
    removeIfLeft(numbered(parent, name, number));
}

std::string
shownPath(const std::string& path)
{
  if (path.find(unfinished_mark) == std::string::npos)
    return path;
  fs::path shown;
  for (const fs::path& part : fs::path(path))
    if (!isHiddenFolderName(part.string()))
      shown /= part;
  return shown.string();
}

} // namespace pcl::acmap
