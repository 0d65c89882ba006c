#include "session_output.h"

#include <filesystem>

namespace pcl::acmap {

namespace fs = std::filesystem;

SessionOutput::SessionOutput(const std::string& folder, const Device& device)
: folder_(folder)
{
  std::error_code error;
  is_new_ = !fs::exists(folder_, error);
  if (device.cameras)
    recorder_.emplace(folder_, device.rig, *device.cameras);
  else
    recorder_.emplace(folder_, device.rig);
}

SessionOutput::~SessionOutput()
{
  if (recorder_->frames() > 0)
    return;
  // files of a failed run would block the next one
  std::error_code error;
  for (const char* const name : {"session.yaml", "rig.yaml"})
    fs::remove(fs::path(folder_) / name, error);
  if (is_new_)
    fs::remove(folder_, error);
}

} // namespace pcl::acmap
