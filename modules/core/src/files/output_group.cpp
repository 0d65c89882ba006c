#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_group.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

std::string
replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

} // namespace

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
