#include <pcl/core/output_folder.h>

#include <pcl/core/exceptions.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>

namespace pcl::acmap {
namespace fs = std::filesystem;

namespace {

/** A folder that was not there: what a killed run of the same number left is none. */
fs::path
makeHidden(const fs::path& folder, std::error_code& error)
{
  static std::atomic<std::uint64_t> counter{0};
  for (;;) {
    const fs::path hidden = folder / (".acmap.tmp-" + std::to_string(getpid()) + "-" +
                                      std::to_string(counter++));
    error.clear();
    if (fs::create_directory(hidden, error))
      return hidden;
    if (error && error != std::errc::file_exists)
      return {};
  }
}

/** \throws OutputFileException when not all could be listed */
std::vector<fs::path>
entriesOf(const fs::path& folder, const std::string& name)
{
  std::vector<fs::path> entries;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    entries.push_back(entry->path());
  if (error)
    throw OutputFileException(name + ": " + error.message());
  return entries;
}

} // namespace

OutputFolder::OutputFolder(const std::string& path)
: name_(path)
, folder_(fs::path(path).lexically_normal())
{
  const auto fail = [&](const std::string& fault) {
    throw OutputFileException(path + ": " + fault);
  };
  std::error_code error;
  if (path.empty())
    fail("names no folder");
  if (fs::exists(folder_, error) && !fs::is_directory(folder_, error))
    fail("is a file, a folder is needed");
  made_ = fs::create_directory(folder_, error);
  if (error)
    fail(error.message());
  hidden_ = makeHidden(folder_, error);
  if (error) {
    const std::string fault = error.message();
    if (made_)
      fs::remove(folder_, error);
    fail(fault);
  }
}

OutputFolder::~OutputFolder()
{
  std::error_code error;
  if (!hidden_.empty())
    fs::remove_all(hidden_, error);
  if (made_)
    fs::remove(folder_, error); // fails when something else lies in it by now
}

std::string
OutputFolder::path(const std::string& name) const
{
  return (hidden_ / name).string();
}

std::vector<std::string>
OutputFolder::names() const
{
  std::vector<std::string> names;
  for (const fs::path& entry : entriesOf(folder_, name_))
    if (entry.filename() != hidden_.filename())
      names.push_back(entry.filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

bool
OutputFolder::holds(const std::string& path) const
{
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(path).parent_path(), error) ==
         fs::weakly_canonical(fs::absolute(folder_ / "").parent_path(), error);
}

void
OutputFolder::commit()
{
  const std::vector<fs::path> files = entriesOf(hidden_, name_);
  std::error_code error;
  for (const fs::path& file : files) // all or none, where that can be foreseen
    if (fs::is_directory(folder_ / file.filename(), error))
      throw OutputFileException((folder_ / file.filename()).string() + ": is a folder");
  for (const fs::path& file : files) {
    fs::rename(file, folder_ / file.filename(), error);
    if (error)
      throw OutputFileException((folder_ / file.filename()).string() + ": " +
                                error.message());
  }
  fs::remove(hidden_, error);
  hidden_.clear();
  made_ = false;
}

} // namespace pcl::acmap
