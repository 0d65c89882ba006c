#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/map_folder.h>
#include <pcl/texture/compact_map_folder.h>

#include <cstring>
#include <filesystem>

namespace pcl {

namespace {

namespace fs = std::filesystem;

/** \brief Reads a cloud, and adds the remarks on it. */
PCLPointCloud2
loadNotedCloud(const fs::path& path, std::vector<std::string>& remarks)
{
  PointCloudFile file = loadPointCloud(path.string());
  remarks.insert(remarks.end(), file.remarks.begin(), file.remarks.end());
  const std::vector<std::string> lengths = acmap::lengthRemarks(file.points());
  remarks.insert(remarks.end(), lengths.begin(), lengths.end());
  return std::move(file.cloud);
}

/** \brief Number of points whose view has no pose. */
std::size_t
pointsWithoutPose(const PCLPointCloud2& cloud, std::size_t poses)
{
  const PCLPointField* const field =
      acmap::findField(cloud, "view", PCLPointField::INT32);
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  std::size_t count = 0;
  for (std::size_t i = 0; field && i < points; ++i) {
    std::int32_t view = 0;
    std::memcpy(&view, &cloud.data[i * cloud.point_step + field->offset], sizeof view);
    count += view < 0 || static_cast<std::size_t>(view) >= poses;
  }
  return count;
}

/** \brief Names what cannot be shown as it was before rectification. */
void
notePosesBefore(MapFolder& result)
{
  const std::size_t before = result.trajectory_before.poses.size();
  const std::size_t after = result.map.trajectory.poses.size();
  if (before != after)
    result.remarks.push_back("trajectory_before.txt has " + std::to_string(before) +
                             " poses, the map " + std::to_string(after) +
                             ": what was before rectification cannot be shown");
  else if (const std::size_t strangers = pointsWithoutPose(result.cloud, after))
    result.remarks.push_back(std::to_string(strangers) +
                             " points were seen from no pose of the map, and are not "
                             "shown before rectification");
}

} // namespace

MapFolder
loadMapFolder(const std::string& folder)
{
  const auto has = [&](const char* name) {
    std::error_code error; // if that cannot be told, reading it gives the reason
    return fs::exists(fs::path(folder) / name, error);
  };
  const auto path = [&](const char* name) {
    return (fs::path(folder) / name).string();
  };
  if (!has("map.json") && !(has("map.pcd") && has(acmap::trajectory_name)))
    throw InputFileException(folder +
                             ": is a folder without a map.json, without both map.pcd "
                             "and trajectory.txt, and without observations (.pcd); of "
                             "other folders only single files can be shown");
  MapFolder result;
  if (has("map.json"))
    result.map = loadCompactMap(folder);
  if (has("mesh.ply")) {
    result.vertices = loadNotedCloud(path("mesh.ply"), result.remarks);
    result.mesh = loadTriangleMesh(path("mesh.ply"));
  }
  if (has("map.pcd"))
    result.cloud = loadNotedCloud(path("map.pcd"), result.remarks);
  if (result.map.trajectory.poses.empty() && has(acmap::trajectory_name))
    result.map.trajectory = loadTrajectory(path(acmap::trajectory_name));
  if (has("trajectory_before.txt")) {
    result.trajectory_before = loadTrajectory(path("trajectory_before.txt"));
    notePosesBefore(result);
  }
  return result;
}

SequenceSample
sampleSequence(const ObservationSequence& sequence,
               std::size_t max_points,
               const ProgressCallback& progress)
{
  const acmap::Progress told(progress);
  const std::size_t share = max_points / sequence.size() + 1;
  SequenceSample sample;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    told.tell(static_cast<double>(i) / static_cast<double>(sequence.size()), "reading");
    const PosedObservation observation = sequence.load(i);
    PointCloud<PointXYZRGB> seen;
    fromPCLPointCloud2(observation.file->cloud, seen);
    const Eigen::Isometry3f pose = observation.T_map_camera.cast<float>();
    for (std::size_t k = 0; k < seen.size(); k += seen.size() / share + 1) {
      PointXYZRGBNormalView point;
      point.getVector3fMap() = pose * seen[k].getVector3fMap();
      point.rgba = seen[k].rgba;
      point.view = static_cast<std::int32_t>(i);
      if (point.getVector3fMap().allFinite())
        sample.points.push_back(point);
    }
    sample.trajectory.stamps.push_back(sequence.stamp(i));
    sample.trajectory.poses.push_back(observation.T_map_camera);
  }
  return sample;
}

} // namespace pcl
