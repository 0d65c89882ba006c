#include "contradicted_output.h"

#include <pcl/core/exceptions.h>

#include <system_error>

namespace pcl::acmap {
namespace {

namespace fs = std::filesystem;

std::map<std::string, fs::file_time_type>
entriesOf(const std::string& folder)
{
  std::map<std::string, fs::file_time_type> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code unknown;
    entries[entry->path().filename().string()] = entry->last_write_time(unknown);
  }
  return entries;
}

} // namespace

ContradictedOutput::ContradictedOutput(const std::string& folder)
: folder_((fs::path(folder) / "").parent_path().string()) // without a slash
, before_(entriesOf(folder))
{
  std::error_code error;
  was_there_ = fs::exists(folder_, error);
}

std::string
ContradictedOutput::setAside() const
{
  const std::string aside = folder_ + ".contradicted";
  std::error_code error;
  if (fs::exists(aside, error)) {
    if (!fs::exists(fs::path(aside) / "report.json", error))
      throw OutputFileException(aside + ": exists and was not made by a run; move it");
    fs::remove_all(aside, error);
  }
  fs::create_directories(aside, error);
  for (const auto& [name, time] : entriesOf(folder_)) {
    const auto found = before_.find(name);
    const bool is_of_run = found == before_.end() || found->second != time;
    if (!error && is_of_run)
      fs::rename(fs::path(folder_) / name, fs::path(aside) / name, error);
  }
  if (error)
    throw OutputFileException(
        aside +
        ": the contradicted result could not be moved there: " + error.message());
  if (!was_there_)
    fs::remove(folder_, error);
  return aside;
}

} // namespace pcl::acmap
