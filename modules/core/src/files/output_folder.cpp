#include <pcl/core/output_folder.h>

#include <pcl/core/exceptions.h>

#include <algorithm>

namespace pcl::acmap {
namespace fs = std::filesystem;

namespace {

/** Removes trailing slashes, so that the path has a file name. */
fs::path
normalized(const std::string& path)
{
  const fs::path folder = fs::path(path).lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

/** Lists a folder with one of the iterators of its entries.
 * \throws OutputFileException when it could not be listed completely */
template <typename Iterator>
std::vector<fs::path>
entriesOf(const fs::path& folder, const std::string& name)
{
  std::vector<fs::path> entries;
  std::error_code error;
  Iterator entry(folder, error);
  for (; !error && entry != Iterator(); entry.increment(error))
    entries.push_back(entry->path());
  if (error)
    throw OutputFileException(name + ": " + error.message());
  return entries;
}

} // namespace

OutputFolder::OutputFolder(const std::string& path)
: name_(path)
, folder_(normalized(path))
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
  try {
    hide();
  }
  catch (const OutputFileException&) {
    if (made_)
      fs::remove(folder_, error);
    throw;
  }
}

void
OutputFolder::hide()
{
  const std::string own_name = folder_.filename().string();
  if (made_) {
    hidden_.emplace(folder_.parent_path(), own_name, name_);
    files_ = hidden_->path() / own_name;
    std::error_code error;
    fs::create_directory(files_, error);
    if (error)
      throw OutputFileException(name_ + ": " + error.message());
    return;
  }
  removeLeftoversOf(folder_.parent_path(), own_name);
  removeLeftoversIn(folder_.string());
  hidden_.emplace(folder_, "", name_);
  files_ = hidden_->path();
}

OutputFolder::~OutputFolder()
{
  std::error_code error;
  hidden_.reset();
  if (made_)
    fs::remove(folder_, error); // fails if there are other files in it by now
}

std::string
OutputFolder::path(const std::string& name) const
{
  return (files_ / name).string();
}

std::vector<std::string>
OutputFolder::names() const
{
  std::vector<std::string> names;
  for (const fs::path& entry : entriesOf<fs::directory_iterator>(folder_, name_))
    if (!isHiddenFolderName(entry.filename().string()))
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
  std::error_code error;
  if (made_)
    fs::rename(files_, folder_, error);
  if (!made_ || error) // other processes have created files there in the meantime
    putFilesInPlace();
  hidden_.reset();
  made_ = false;
}

void
OutputFolder::putFilesInPlace() const
{
  const auto fail = [&](const fs::path& place, const std::string& fault) {
    throw OutputFileException(place.string() + ": " + fault);
  };
  std::error_code error;
  std::vector<fs::path> names, folders; // relative to the folder
  for (const fs::path& entry :
       entriesOf<fs::recursive_directory_iterator>(files_, name_))
    (fs::is_directory(entry, error) ? folders : names)
        .push_back(entry.lexically_relative(files_));
  // all or none, as far as this can be detected beforehand
  for (const fs::path& name : names)
    if (fs::is_directory(folder_ / name, error))
      fail(folder_ / name, "is a folder");
  for (const fs::path& name : folders)
    if (fs::exists(folder_ / name, error) && !fs::is_directory(folder_ / name, error))
      fail(folder_ / name, "is a file");
  for (const fs::path& name : folders) {
    fs::create_directories(folder_ / name, error);
    if (error)
      fail(folder_ / name, error.message());
  }
  for (const fs::path& name : names) {
    fs::rename(files_ / name, folder_ / name, error);
    if (error)
      fail(folder_ / name, error.message());
  }
}

} // namespace pcl::acmap
