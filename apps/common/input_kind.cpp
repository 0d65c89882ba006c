#include "input_kind.h"

#include "output_target.h"

#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace pcl::acmap {
namespace {

namespace fs = std::filesystem;

bool
begins(const std::string& text, const std::string& with)
{
  return text.rfind(with, 0) == 0;
}

std::set<std::string>
namesIn(const fs::path& folder)
{
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    names.insert(entry->path().filename().string());
  return names;
}

InputKind
kindOfFolder(const fs::path& folder)
{
  const std::set<std::string> names = namesIn(folder);
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
  return count(".png") + count(".jpg") + count(".jpeg") + count(".pgm") +
                     count(".ppm") >
                 0
             ? InputKind::Images
             : InputKind::Unknown;
}

std::string
firstBytes(const std::string& path)
{
  constexpr std::size_t count = 4096;
  std::string bytes(count, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(count));
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
      if (begins(line, message))
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
  for (const char* known : {".pcd", ".ply", ".obj", ".xyz"})
    if (ending == known)
      return InputKind::Cloud;
  const std::string bytes = firstBytes(path);
  if (ending == ".json")
    return bytes.find("\"planes\"") != bytes.npos ? InputKind::Planes
                                                  : InputKind::Unknown;
  return beginsAsCarmenLog(bytes) ? InputKind::CarmenLog : InputKind::Unknown;
}

/** \brief The arguments that accept an input of the kind, as "tool argument". */
const std::multimap<InputKind, std::string>&
rightDoors()
{
  static const std::multimap<InputKind, std::string> doors = {
      {InputKind::RgbdFolder, "pcl_rgbd_import input"},
      {InputKind::RawSession, "pcl_active_stereo session"},
      {InputKind::RawSession, "pcl_compact_mapping input"},
      {InputKind::RawSession, "pcl_paper_figures session"},
      {InputKind::CompactMap, "pcl_compact_viewer input"},
      {InputKind::CompactMap, "pcl_paper_figures map"},
      {InputKind::MergedMap, "pcl_compact_viewer input"},
      {InputKind::MergedMap, "pcl_paper_figures map"}, // without its map.json
      {InputKind::Observations, "pcl_compact_mapping input"},
      {InputKind::Observations, "pcl_entropy_rectification posed"},
      {InputKind::Observations, "pcl_plane_texturing observations"},
      {InputKind::Observations, "pcl_visual_egomotion observations"},
      {InputKind::Planes, "pcl_compact_viewer input"},
      {InputKind::Planes, "pcl_plane_texturing planes"},
      {InputKind::Cloud, "pcl_compact_mapping input"},
      {InputKind::Cloud, "pcl_compact_viewer input"},
      {InputKind::Cloud, "pcl_dewall_surface input"},
      {InputKind::Cloud, "pcl_plane_extraction input"},
      {InputKind::Cloud, "pcl_plane_texturing observations"},
      {InputKind::Cloud, "pcl_visual_egomotion observations"},
  };
  return doors;
}

std::string
adviceFor(InputKind kind, const std::string& path)
{
  switch (kind) {
  case InputKind::RgbdFolder:
    return path + " is an RGB-D recording: first run pcl_rgbd_import " + path +
           " -o observations";
  case InputKind::RawSession:
    return path + " is a raw session: run pcl_active_stereo " + path +
           " -o observations for point clouds, or pcl_compact_mapping " + path +
           " -o map for a map";
  case InputKind::CompactMap:
    return path + " is a compact map already: run pcl_compact_viewer " + path +
           " to see it; its planes are " + path + "/map.json";
  case InputKind::MergedMap:
    return path +
           " holds poses and a merged map, no observations: run "
           "pcl_entropy_rectification with --observations to have those, or "
           "give " +
           path + "/map.pcd as one cloud";
  case InputKind::Observations:
    return path + " is a folder of point clouds: run pcl_compact_mapping " + path +
           " -o map for a map, or give one of its files";
  case InputKind::Images:
    return path + " holds images: those of a stereo rig go to pcl_active_stereo "
                  "--reference IMG.. --horizontal IMG.. --rig RIG.yaml -o observations";
  case InputKind::CarmenLog:
    return path + " is a laser log of CARMEN: run pcl_entropy_rectification --carmen " +
           path + " -o straight";
  case InputKind::Planes:
    return path + " holds planes: run pcl_plane_texturing " + path +
           " POSED_DIR -o map to paint them, or pcl_compact_viewer " + path +
           " to see them";
  case InputKind::Cloud:
    return path + " is a point cloud or a mesh: run pcl_dewall_surface " + path +
           " mesh.ply for a mesh, or pcl_plane_extraction " + path +
           " planes.json for planes";
  default:
    return {};
  }
}

} // namespace

InputKind
inputKindOf(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
    return kindOfFolder(path);
  return fs::is_regular_file(path, error) ? kindOfFile(path) : InputKind::Unknown;
}

std::string
toolForInput(const std::string& tool,
             const std::string& positional,
             const std::string& path)
{
  const InputKind kind = inputKindOf(path);
  const auto doors = rightDoors().equal_range(kind);
  const bool is_right = std::any_of(doors.first, doors.second, [&](const auto& door) {
    return door.second == tool + " " + positional;
  });
  return is_right ? std::string() : adviceFor(kind, path);
}

} // namespace pcl::acmap
