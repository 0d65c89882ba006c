#include "viewer_input.h"

#include "exit_code.h"
#include "length_check.h"
#include "output_target.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/map_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/visualization/scene_file.h>

#include <cstring>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** Does a path exist? If that cannot be determined, reading it later gives the
 * reason. */
bool
isThere(const fs::path& path)
{
  std::error_code error;
  return fs::exists(path, error);
}

void
note(const PointCloudFile& file, double scale, std::vector<std::string>& remarks)
{
  remarks.insert(remarks.end(), file.remarks.begin(), file.remarks.end());
  for (const std::string& remark : lengthRemarks(file.points(), 0, scale))
    remarks.push_back(remark);
}

ViewerInput
loadFile(const std::string& path, double scale)
{
  SceneFile file = loadScene(path);
  scaleCloud(file.points, scale);
  if (cloudExtent(file.points.points()).finite_points == 0)
    throw NothingFound(path + ": nothing to show, no point is finite");
  ViewerInput input;
  note(file.points, scale, input.remarks);
  input.sensor_origin = file.points.sensor_origin;
  input.sensor_orientation = file.points.sensor_orientation;
  if (endingOf(path) == ".obj")
    input.up = Eigen::Vector3f::UnitY();
  LayeredScene& scene = input.scene;
  (file.mesh.triangles.empty() ? scene.points : scene.vertices) =
      std::move(file.points.cloud);
  scene.mesh = std::move(file.mesh);
  return input;
}

void
loadCloudOf(const fs::path& folder, ViewerInput& input)
{
  PointCloudFile cloud = loadPointCloud((folder / "map.pcd").string());
  note(cloud, 1, input.remarks);
  input.scene.points = std::move(cloud.cloud);
}

void
loadMeshOf(const fs::path& folder, ViewerInput& input)
{
  SceneFile mesh = loadScene((folder / "mesh.ply").string());
  note(mesh.points, 1, input.remarks);
  input.scene.vertices = std::move(mesh.points.cloud);
  input.scene.mesh = std::move(mesh.mesh);
}

/** \brief Number of points whose view has no pose. */
std::size_t
pointsOfNoPose(const LayeredScene& scene)
{
  const PCLPointCloud2& cloud = scene.points;
  const PCLPointField* const field = findField(cloud, "view", PCLPointField::INT32);
  const std::size_t poses = scene.map.trajectory.poses.size();
  std::size_t count = 0;
  for (std::size_t i = 0; field && i < pointsIn(scene); ++i) {
    std::int32_t view = 0;
    std::memcpy(&view, &cloud.data[i * cloud.point_step + field->offset], sizeof view);
    count += view < 0 || static_cast<std::size_t>(view) >= poses;
  }
  return count;
}

/** \brief Loads the poses before rectification, if there are as many as after it. */
void
loadPosesBefore(const fs::path& folder, ViewerInput& input)
{
  LayeredScene& scene = input.scene;
  scene.trajectory_before = loadTrajectory((folder / "trajectory_before.txt").string());
  const std::size_t before = scene.trajectory_before.poses.size();
  const std::size_t after = scene.map.trajectory.poses.size();
  if (before != after)
    input.remarks.push_back("trajectory_before.txt has " + std::to_string(before) +
                            " poses, the map " + std::to_string(after) +
                            ": what was before rectification cannot be shown");
  else if (const std::size_t strangers = pointsOfNoPose(scene); strangers != 0)
    input.remarks.push_back(std::to_string(strangers) +
                            " points were seen from no pose of the map, and are not "
                            "shown before rectification");
}

ViewerInput
loadFolder(const fs::path& folder)
{
  const bool has_map = isThere(folder / "map.json");
  const bool has_cloud = isThere(folder / "map.pcd");
  const bool has_poses = isThere(folder / "trajectory.txt");
  if (!has_map && !(has_cloud && has_poses))
    throw InputFileException(folder.string() +
                             ": is a folder without a map.json, and without both "
                             "map.pcd and trajectory.txt; of other folders only "
                             "single files can be shown");
  ViewerInput input;
  if (has_map)
    input.scene.map = loadCompactMap(folder.string());
  if (isThere(folder / "mesh.ply"))
    loadMeshOf(folder, input);
  if (has_cloud)
    loadCloudOf(folder, input);
  Trajectory& trajectory = input.scene.map.trajectory;
  if (trajectory.poses.empty() && has_poses)
    trajectory = loadTrajectory((folder / "trajectory.txt").string());
  if (isThere(folder / "trajectory_before.txt"))
    loadPosesBefore(folder, input);
  return input;
}

} // namespace

ViewerInput
loadViewerInput(const std::string& path, double scale)
{
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  const bool is_map = is_folder || endingOf(path) == ".json";
  if (!is_map)
    return loadFile(path, scale);
  if (scale != 1)
    throw UsageError("--scale is for clouds and meshes; maps are in metres");
  ViewerInput input;
  if (is_folder)
    input = loadFolder(path);
  else
    input.scene.map = loadMapFile(path);
  if (input.scene.map.planes.empty() && pointsIn(input.scene) == 0)
    throw NothingFound(path + ": nothing to show, there is no plane");
  return input;
}

std::size_t
pointsIn(const LayeredScene& scene)
{
  const auto size = [](const PCLPointCloud2& cloud) {
    return std::size_t{cloud.width} * cloud.height;
  };
  return size(scene.points) != 0 ? size(scene.points) : size(scene.vertices);
}

} // namespace pcl::acmap
