#include "output_group.h"

#include <pcl/core/output_file.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {
namespace fs = std::filesystem;
namespace {

std::string
placeBeside(const fs::path& target, std::size_t number)
{
  constexpr std::size_t longest = 200; // keeps the whole below the usual limit of 255
  const std::string name = "." + target.stem().string().substr(0, longest) + ".tmp-" +
                           std::to_string(getpid()) + "-" + std::to_string(number);
  return (target.parent_path() / (name + target.extension().string())).string();
}

std::string
replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

} // namespace

OutputGroup::~OutputGroup()
{
  std::error_code error;
  for (const Entry& entry : entries_)
    fs::remove(entry.place, error);
}

void
OutputGroup::write(const std::string& path,
                   const std::function<void(const std::string& place)>& save)
{
  const fs::path target = followLinks(path);
  std::error_code error;
  if (fs::exists(target, error) && access(target.c_str(), W_OK) != 0)
    throw OutputFileException(path + ": " + std::strerror(errno));
  const std::string place = placeBeside(target, entries_.size());
  entries_.push_back({path, target.string(), place});
  try {
    save(place);
  }
  catch (const OutputFileException& e) {
    throw OutputFileException(replaced(e.what(), place, path));
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
