#include <pcl/core/output_folder.h>

#include <pcl/core/exceptions.h>

#include <unistd.h>

#include <algorithm>

namespace pcl::acmap {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& path)
: name_(path)
, folder_(fs::path(path).lexically_normal())
, hidden_(folder_ / (".acmap.tmp-" + std::to_string(getpid())))
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
  if (!fs::create_directory(hidden_, error) && error) {
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
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error))
    if (entry.path().filename() != hidden_.filename())
      names.push_back(entry.path().filename().string());
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
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(hidden_, error))
    files.push_back(entry.path());
  std::error_code absent;
  for (const fs::path& file : files) // all or none, where that can be foreseen
    if (fs::is_directory(folder_ / file.filename(), absent))
      throw OutputFileException((folder_ / file.filename()).string() + ": is a folder");
  for (const fs::path& file : files) {
    if (!error)
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
