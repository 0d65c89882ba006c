#include "posed_folder.h"

#include "observation_folder.h"
#include "output_target.h"
#include "scaled_cloud.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** Names of all PCD files, ascending. */
std::vector<std::string>
pcdNames(const std::string& folder)
{
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputFileException(folder + ": is no folder");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (endingOf(entry.path().string()) == ".pcd" && !entry.is_directory(error))
      names.push_back(entry.path().filename().string());
  if (error)
    throw InputFileException(folder + ": cannot be read (" + error.message() + ")");
  std::sort(names.begin(), names.end());
  return names;
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

std::vector<std::string>
observationNames(const std::string& folder)
{
  std::vector<std::string> names = pcdNames(folder), numbered;
  for (const std::string& name : names)
    if (numberOf(name))
      numbered.push_back(name);
  // as text, observation_10000 would stand before observation_9999
  std::sort(
      numbered.begin(), numbered.end(), [](const std::string& a, const std::string& b) {
        return std::pair(*numberOf(a), a) < std::pair(*numberOf(b), b);
      });
  if (!numbered.empty())
    return numbered;
  if (names.empty())
    throw InputFileException(folder + ": holds no .pcd file");
  return names;
}

/** Rows of the trajectory: by number where the names have one, else one after the other. */
std::vector<std::size_t>
rowsOf(const std::string& folder,
       const std::vector<std::string>& names,
       std::size_t poses)
{
  std::vector<std::size_t> rows;
  for (const std::string& name : names) {
    const std::size_t row = numberOf(name).value_or(rows.size());
    if (row >= poses)
      throw InputFileException(folder + ": " + trajectory_name + " has " +
                               std::to_string(poses) + " poses, none for " + name);
    rows.push_back(row);
  }
  return rows;
}

Eigen::Isometry3d
viewpointOf(const PointCloudFile& file)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      file.sensor_orientation.cast<double>().normalized().toRotationMatrix();
  pose.translation() = file.sensor_origin.cast<double>();
  return pose;
}

bool
isKnown(const Eigen::Isometry3d& viewpoint)
{
  return !viewpoint.matrix().isIdentity(0);
}

} // namespace

PosedFolder::PosedFolder(const std::string& path, double scale)
: path_(path)
, scale_(scale)
, names_(observationNames(path))
{
  const fs::path trajectory = fs::path(path) / trajectory_name;
  std::error_code error;
  if (!fs::exists(trajectory, error))
    return;
  trajectory_ = loadTrajectory(trajectory.string());
  rows_ = rowsOf(path, names_, trajectory_.poses.size());
  for (Eigen::Isometry3d& pose : trajectory_.poses)
    pose.translation() *= scale;
}

std::string
PosedFolder::path(std::size_t i) const
{
  return (fs::path(path_) / names_[i]).string();
}

PosedObservation
PosedFolder::load(std::size_t i, std::vector<std::string>& remarks) const
{
  PosedObservation observation;
  observation.file = loadScaledCloud(path(i), scale_);
  const Eigen::Isometry3d viewpoint = viewpointOf(observation.file);
  if (!hasTrajectory()) {
    observation.T_map_camera = viewpoint;
    return observation;
  }
  observation.T_map_camera = trajectory_.poses[rows_[i]];
  const double apart =
      (observation.T_map_camera.translation() - viewpoint.translation()).norm();
  constexpr double most_apart = 0.001; // metres
  if (isKnown(viewpoint) && apart > most_apart)
    remarks.push_back(path(i) + ": its VIEWPOINT is " + std::to_string(apart) +
                      " m from its pose in " + trajectory_name + ", which holds");
  return observation;
}

void
PosedFolder::requireDifferent(const std::vector<Eigen::Isometry3d>& poses) const
{
  if (poses.size() < 2 || hasTrajectory())
    return;
  for (const Eigen::Isometry3d& pose : poses)
    if (pose.matrix() != poses.front().matrix())
      return;
  throw InputFileException(path_ + ": the observations have no poses: there is no " +
                           trajectory_name + ", and their VIEWPOINTs are all the same");
}

double
PosedFolder::stamp(std::size_t i) const
{
  return hasTrajectory() ? trajectory_.stamps[rows_[i]] : static_cast<double>(i);
}

} // namespace pcl::acmap
