#include "input_kind.h"

#include "output_target.h"

#include <pcl/core/bag_file.h>
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
firstBytes(const std::string& path)
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
  const std::string bytes = firstBytes(path);
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

/** \brief The tools for an input. */
struct ToolsForInput {
  std::vector<std::string> doors; ///< arguments that accept it, as "tool argument"
  std::string advice;             ///< sentence with a command; a % is the input's path
};

const std::map<InputKind, ToolsForInput>&
toolsForInputs()
{
  static const std::map<InputKind, ToolsForInput> tools = {
      {InputKind::RgbdFolder,
       {{"pcl_compact_mapping input", "pcl_rgbd_import input"},
        "% is an RGB-D recording: run pcl_compact_mapping % -o map for a map, or first "
        "pcl_rgbd_import % -o observations"}},
      {InputKind::RawSession,
       {{"pcl_active_stereo session",
         "pcl_compact_mapping input",
         "acmap_paper_figures session"},
        "% is a raw session: run pcl_active_stereo % -o observations for point clouds, "
        "or pcl_compact_mapping % -o map for a map"}},
      {InputKind::CompactMap,
       {{"pcl_compact_viewer input", "acmap_paper_figures map"},
        "% is a compact map already: run pcl_compact_viewer % to see it; its planes "
        "are %/map.json"}},
      {InputKind::MergedMap,
       {{"pcl_compact_viewer input", "acmap_paper_figures map"}, // without its map.json
        "% holds poses and a merged map, no observations: run "
        "pcl_entropy_rectification with --observations to have those, or give "
        "%/map.pcd as one cloud"}},
      {InputKind::Observations,
       {{"pcl_compact_mapping input",
         "pcl_entropy_rectification posed",
         "pcl_plane_texturing observations",
         "pcl_visual_egomotion observations"},
        "% is a folder of point clouds: run pcl_compact_mapping % -o map for a map, or "
        "give one of its files"}},
      {InputKind::Images,
       {{},
        "% holds images: those of a stereo rig go to pcl_active_stereo --reference "
        "IMG.. --horizontal IMG.. --rig RIG.yaml -o observations"}},
      {InputKind::CarmenLog,
       {{},
        "% is a laser log of CARMEN: run pcl_entropy_rectification --carmen % -o "
        "straight"}},
      {InputKind::Bag,
       {{"pcl_compact_mapping input", "pcl_entropy_rectification posed"},
        "% is a bag of ROS: run pcl_compact_mapping % -o map for a map of its images "
        "or "
        "clouds, or pcl_entropy_rectification % -o straight for one of its laser "
        "scans"}},
      {InputKind::Planes,
       {{"pcl_compact_viewer input", "pcl_plane_texturing planes"},
        "% holds planes: run pcl_plane_texturing % POSED_DIR -o map to paint them, or "
        "pcl_compact_viewer % to see them"}},
      {InputKind::Cloud,
       {{"pcl_cloud_info input",
         "pcl_compact_mapping input",
         "pcl_compact_viewer input",
         "pcl_dewall_surface input",
         "pcl_plane_extraction input",
         "pcl_plane_texturing observations",
         "pcl_visual_egomotion observations"},
        "% is a point cloud or a mesh: run pcl_dewall_surface % mesh.ply for a mesh, "
        "or "
        "pcl_plane_extraction % planes.json for planes"}}};
  return tools;
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

std::string
toolForInput(const std::string& tool,
             const std::string& positional,
             const std::string& path)
{
  const auto tools = toolsForInputs().find(inputKindOf(path));
  if (tools == toolsForInputs().end())
    return {};
  const auto& [doors, advice] = tools->second;
  if (std::count(doors.begin(), doors.end(), tool + " " + positional) > 0)
    return {};
  std::string text;
  for (const char letter : advice)
    text += letter == '%' ? path : std::string(1, letter);
  return text;
}

} // namespace pcl::acmap
