#include "viewer_input.h"

#include "exit_code.h"
#include "length_check.h"
#include "output_target.h"
#include "scaled_cloud.h"

#include <pcl/core/map_file.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/visualization/scene_file.h>

#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** What cannot be told is not there; who reads it says why. */
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
  LayeredScene& scene = input.scene;
  (file.mesh.triangles.empty() ? scene.points : scene.vertices) =
      std::move(file.points.cloud);
  scene.mesh = std::move(file.mesh);
  return input;
}

ViewerInput
loadFolder(const fs::path& folder)
{
  if (!isThere(folder / "map.json"))
    throw InputFileException(folder.string() +
                             ": is a folder without a map.json; of other folders only "
                             "single files can be shown");
  ViewerInput input;
  LayeredScene& scene = input.scene;
  scene.map = loadCompactMap(folder.string());
  if (isThere(folder / "mesh.ply")) {
    SceneFile mesh = loadScene((folder / "mesh.ply").string());
    note(mesh.points, 1, input.remarks);
    scene.vertices = std::move(mesh.points.cloud);
    scene.mesh = std::move(mesh.mesh);
  }
  if (isThere(folder / "map.pcd")) {
    PointCloudFile cloud = loadPointCloud((folder / "map.pcd").string());
    note(cloud, 1, input.remarks);
    scene.points = std::move(cloud.cloud);
  }
  if (scene.map.trajectory.poses.empty() && isThere(folder / "trajectory.txt"))
    scene.map.trajectory = loadTrajectory((folder / "trajectory.txt").string());
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
