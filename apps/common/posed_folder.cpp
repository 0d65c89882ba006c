#include "posed_folder.h"

#include "observation_folder.h"
#include "observation_names.h"
#include "scaled_cloud.h"
#include "tool.h"

#include <filesystem>
#include <numeric>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

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
  rows_ = trajectoryRows(trajectory.string(), names_, trajectory_.poses.size());
  for (Eigen::Isometry3d& pose : trajectory_.poses)
    pose.translation() *= scale;
}

PosedFolder::PosedFolder(const std::string& path,
                         double scale,
                         std::vector<std::string> names,
                         Trajectory trajectory)
: path_(path)
, scale_(scale)
, names_(std::move(names))
, rows_(names_.size())
, trajectory_(std::move(trajectory))
, is_given_(true)
{
  if (trajectory_.poses.size() != names_.size())
    throw InputFileException(path + ": has " + std::to_string(names_.size()) +
                             " observations, the trajectory " +
                             std::to_string(trajectory_.poses.size()) + " poses");
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
}

std::vector<std::string>
PosedFolder::remarks() const
{
  const std::size_t poses = trajectory_.poses.size();
  if (poses <= names_.size())
    return {};
  return {(fs::path(path_) / trajectory_name).string() + ": has " +
          std::to_string(poses) + " poses, the folder " +
          std::to_string(names_.size()) + " observations: the others are missing"};
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
  if (!is_given_ && isKnown(viewpoint) && apart > most_apart)
    remarks.push_back(path(i) + ": its VIEWPOINT is " + shortNumber(apart) +
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
                           trajectory_name +
                           ", and their VIEWPOINTs are all the same; "
                           "pcl_visual_egomotion finds poses");
}

double
PosedFolder::stamp(std::size_t i) const
{
  return hasTrajectory() ? trajectory_.stamps[rows_[i]] : static_cast<double>(i);
}

} // namespace pcl::acmap
