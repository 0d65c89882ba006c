#include "observations/folder_names.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/bag_file.h>
#include <pcl/pipeline/input_kind.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

namespace pcl {

namespace {

using acmap::endingOf;
using acmap::namesOfFolder;
using acmap::trajectory_name;

namespace fs = std::filesystem;

InputKind
kindOfFolder(const fs::path& folder)
{
  const std::set<std::string> names = namesOfFolder(folder);
  const auto has = [&](const char* name) { return names.count(name) > 0; };
  const auto count = [&](const char* ending) {
    return std::count_if(names.begin(), names.end(), [&](const std::string& name) {
      return endingOf(name) == ending;
    });
  };
  if (has("session.yaml") || count(".acf") > 0)
    return InputKind::RawSession;
  const auto observations = count(".pcd") - (has("map.pcd") ? 1 : 0);
  if (observations > 0)
    return InputKind::Observations;
  if (has("map.json"))
    return InputKind::CompactMap;
  if (has("map.pcd"))
    return has(trajectory_name) ? InputKind::MergedMap : InputKind::Observations;
  if (isRgbdFolder(folder.string()))
    return InputKind::RgbdFolder;
  if (BagFile::isBag(folder.string()))
    return InputKind::Bag;
  if (count(".ply") + count(".las") + count(".e57") + count(".xyz") + count(".bin") >
          0 ||
      has("velodyne"))
    return InputKind::Observations;
  return count(".png") + count(".jpg") + count(".jpeg") + count(".pgm") +
                     count(".ppm") >
                 0
             ? InputKind::Images
             : InputKind::Unknown;
}

std::string
firstBytesOf(const std::string& path)
{
  std::string bytes(4096, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

bool
beginsAsCarmenLog(const std::string& bytes)
{
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);)
    for (const char* message :
         {"FLASER ", "RLASER ", "ODOM ", "PARAM ", "ROBOTLASER1 "})
      if (line.rfind(message, 0) == 0)
        return true;
  return false;
}

InputKind
kindOfFile(const std::string& path)
{
  std::string ending = endingOf(path);
  if (ending == ".gz")
    ending = endingOf(fs::path(path).stem().string());
  if (ending == ".log" || ending == ".clf")
    return InputKind::CarmenLog;
  if (BagFile::isBag(path))
    return InputKind::Bag;
  const std::string bytes = firstBytesOf(path);
  if (beginsAsCarmenLog(bytes)) // whatever its ending
    return InputKind::CarmenLog;
  for (const char* known : {".pcd",
                            ".ply",
                            ".obj",
                            ".xyz",
                            ".txt",
                            ".csv",
                            ".asc",
                            ".pts",
                            ".ptx",
                            ".xyzrgb",
                            ".xyzn",
                            ".las",
                            ".laz",
                            ".e57"})
    if (ending == known)
      return InputKind::Cloud;
  const bool has_planes =
      ending == ".json" && bytes.find("\"planes\"") != std::string::npos;
  return has_planes ? InputKind::Planes : InputKind::Unknown;
}

} // namespace

InputKind
inputKindOf(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
    return kindOfFolder(path);
  const bool is_file = fs::is_regular_file(path, error) || BagFile::isBag(path);
  return is_file ? kindOfFile(path) : InputKind::Unknown;
}

} // namespace pcl
