#include "rgbd/foreign_layouts.h"
#include "rgbd/image_folder.h"
#include "rgbd/text_rows.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/output_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <locale>
#include <numeric>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** A map.pcd next to a map.json or a trajectory is a merged map. */
bool
holdsMergedMapOnly(const fs::path& folder, const std::vector<std::string>& names)
{
  std::error_code error;
  return names == std::vector<std::string>{"map.pcd"} &&
         (fs::exists(folder / "map.json", error) ||
          fs::exists(folder / trajectory_name, error));
}

/** \brief Names of the files of a folder with an ending, without hidden ones. */
std::vector<std::string>
namesWith(const std::string& ending, const fs::path& folder)
{
  std::vector<std::string> names;
  for (const fs::path& entry : folderEntries(folder.string())) {
    std::string name = entry.filename().string();
    if (endingOf(entry) == ending && name.rfind('.', 0) != 0)
      names.push_back(std::move(name));
  }
  return names;
}

/** \brief Clouds of the first kind that a folder has: relative paths, since KITTI has a
 * folder of its own for them. */
std::vector<std::string>
cloudNames(const std::string& folder)
{
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputFileException(folder + ": is no folder");
  if (std::vector<std::string> names = namesWith(".pcd", folder); !names.empty()) {
    if (holdsMergedMapOnly(folder, names))
      throw InputFileException(folder + ": its only .pcd file is a merged map, and no "
                                        "observation");
    return names;
  }
  for (const char* name : {"map.json", "session.yaml"}) // beside meshes of acmap
    if (fs::exists(fs::path(folder) / name, error))
      throw InputFileException(folder + ": holds no .pcd file");
  for (const char* ending : {".ply", ".las", ".e57", ".xyz", ".bin"})
    if (std::vector<std::string> names = namesWith(ending, folder); !names.empty())
      return names;
  std::vector<std::string> scans;
  const fs::path velodyne = fs::path(folder) / "velodyne";
  if (fs::is_directory(velodyne, error))
    for (const std::string& name : namesWith(".bin", velodyne))
      scans.push_back((fs::path("velodyne") / name).string());
  if (scans.empty()) {
    refuseForeignLayout(folder);
    throw InputFileException(folder + ": holds no .pcd file");
  }
  return scans;
}

/** The number in observation_0012.pcd; nothing in other names. */
std::optional<std::size_t>
numberOf(const std::string& name)
{
  constexpr std::string_view prefix = "observation_", ending = ".pcd";
  if (name.size() <= prefix.size() + ending.size() ||
      name.compare(0, prefix.size(), prefix) != 0)
    return std::nullopt;
  const char* const end = name.data() + name.size() - ending.size();
  std::size_t number = 0;
  const auto result = std::from_chars(name.data() + prefix.size(), end, number);
  if (result.ec != std::errc() || result.ptr != end)
    return std::nullopt;
  return number;
}

} // namespace

std::string
numberedName(const std::string& begin, std::size_t index, const std::string& ending)
{
  constexpr std::size_t digits = 4;
  const std::string number = std::to_string(index);
  return begin + "_" + std::string(digits - std::min(digits, number.size()), '0') +
         number + ending;
}

std::string
observationName(std::size_t index)
{
  return numberedName("observation", index, ".pcd");
}

bool
isSequenceName(const std::string& name)
{
  return name.rfind("observation_", 0) == 0 || name == trajectory_name ||
         name == times_name;
}

bool
isNumbered(const std::string& name)
{
  return numberOf(name).has_value();
}

std::vector<std::string>
inSequence(std::vector<std::string> names)
{
  std::vector<std::string> numbered;
  for (const std::string& name : names)
    if (numberOf(name))
      numbered.push_back(name);
  // Sorted as text, observation_10000 would precede observation_9999.
  std::sort(
      numbered.begin(), numbered.end(), [](const std::string& a, const std::string& b) {
        return std::pair(*numberOf(a), a) < std::pair(*numberOf(b), b);
      });
  if (!numbered.empty())
    return numbered;
  std::sort(names.begin(), names.end(), &isBeforeByNumbers);
  return names;
}

std::vector<std::string>
observationNames(const std::string& folder)
{
  return inSequence(cloudNames(folder));
}

std::vector<std::string>
observationPaths(const std::string& folder)
{
  std::vector<std::string> paths = observationNames(folder);
  for (std::string& path : paths)
    path = (fs::path(folder) / path).string();
  return paths;
}

std::vector<std::size_t>
trajectoryRows(const std::string& trajectory,
               const std::vector<std::string>& names,
               std::size_t rows)
{
  std::vector<std::size_t> found(names.size());
  std::iota(found.begin(), found.end(), std::size_t{0});
  if (names.size() == rows)
    return found;
  for (std::size_t& row : found) {
    const std::string& name = names[row];
    row = numberOf(name).value_or(row);
    if (row >= rows)
      throw InputFileException(trajectory + ": has " + std::to_string(rows) +
                               " poses, none for " + name);
  }
  return found;
}

void
saveTimes(const std::string& path, const std::vector<double>& times)
{
  std::ostringstream lines;
  lines.imbue(std::locale::classic());
  lines.precision(std::numeric_limits<double>::max_digits10);
  for (const double time : times)
    lines << time << '\n';
  const std::string text = lines.str();
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

std::vector<double>
loadTimes(const std::string& path)
{
  std::vector<double> times;
  for (const TextRow& row : loadTextRows(path))
    times.push_back(numberOf(path, row, 0));
  return times;
}

std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 std::vector<std::string>& remarks)
{
  std::vector<Eigen::Vector3f> viewpoints;
  if (!findField(file.cloud, "view", PCLPointField::INT32) || !file.viewpoints.empty())
    return file.viewpoints;
  const auto trajectory = fs::path(path).replace_filename("trajectory.txt");
  if (!fs::exists(trajectory))
    remarks.push_back(
        "no " + trajectory.string() +
        ": the points name their views, but where these stood is unknown");
  else
    for (const Eigen::Isometry3d& pose : loadTrajectory(trajectory.string()).poses)
      viewpoints.push_back((pose.translation() * scale).cast<float>());
  return viewpoints;
}

void
saveObservation(const std::string& path,
                const PCLPointCloud2& cloud,
                const Eigen::Isometry3d& T_map_camera)
{
  const Eigen::Vector3d origin = T_map_camera.translation();
  const Eigen::Quaterniond orientation(T_map_camera.linear());
  savePointCloud(
      path, cloud, origin.cast<float>(), orientation.cast<float>().normalized());
}

} // namespace pcl::acmap
