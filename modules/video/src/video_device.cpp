#include "video_device.h"

#include <pcl/core/camera_exception.h>
#include <pcl/video/video_source.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

bool
isNumber(const std::string& text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isdigit(c) != 0;
  });
}

std::string
pathOf(const std::string& device)
{
  return isNumber(device) ? "/dev/video" + device : device;
}

VideoDevice
findPath(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    throw CameraException(CameraFault::NotFound, path + ": there is no such camera");
  if (fs::is_directory(status))
    throw InputFileException(path + ": is a folder, no camera and no video");
  const bool is_camera = fs::is_character_file(status);
  if (access(path.c_str(), is_camera ? R_OK | W_OK : R_OK) != 0)
    throw CameraException(
        CameraFault::PermissionDenied,
        path + ": permission denied" +
            (is_camera ? "; your user must be in the group video" : ""));
  return {is_camera ? VideoKind::Camera : VideoKind::File, path};
}

} // namespace

VideoDevice
findVideoDevice(const std::string& device)
{
  const auto contains = [&](const char* text) {
    return device.find(text) != std::string::npos;
  };
  if (contains("!"))
    return {VideoKind::Pipeline, device};
  if (contains("://"))
    return {VideoKind::Network, device};
  if (contains("%"))
    return {VideoKind::Images, device};
  return findPath(pathOf(device));
}

bool
isSameVideo(const std::string& a, const std::string& b)
{
  std::error_code error;
  return a == b || fs::equivalent(pathOf(a), pathOf(b), error);
}

} // namespace pcl::acmap

namespace pcl {

std::vector<SystemCamera>
listSystemCameras()
{
  namespace fs = std::filesystem;
  std::vector<SystemCamera> cameras;
  std::error_code error;
  for (fs::directory_iterator entry("/sys/class/video4linux", error), end;
       !error && entry != end;
       entry.increment(error)) {
    SystemCamera camera;
    const std::string file = entry->path().filename();
    if (std::sscanf(file.c_str(), "video%d", &camera.number) != 1)
      continue;
    int index = 0;
    std::ifstream(entry->path() / "index") >> index;
    if (index != 0)
      continue;
    std::ifstream name(entry->path() / "name");
    std::getline(name, camera.name);
    cameras.push_back(camera);
  }
  std::sort(cameras.begin(), cameras.end(), [](const auto& a, const auto& b) {
    return a.number < b.number;
  });
  return cameras;
}

} // namespace pcl
