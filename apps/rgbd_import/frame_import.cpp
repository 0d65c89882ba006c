#include "frame_import.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace pcl::acmap {

namespace {

/** \brief Pose in the map, which is the frame of the first written camera. */
Eigen::Isometry3d
poseInMap(const Eigen::Isometry3d& T_world_camera, RgbdImport& import)
{
  if (import.trajectory.poses.empty()) {
    import.T_first_world = T_world_camera.inverse();
    return Eigen::Isometry3d::Identity();
  }
  return import.T_first_world * T_world_camera;
}

void
countDepths(const PCLPointCloud2& cloud, double depth_scale, RgbdImport& import)
{
  const std::size_t offset = findField(cloud, "z")->offset;
  const auto most = static_cast<double>(import.depths.size() - 1);
  bool is_empty = true;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    float z = 0;
    std::memcpy(&z, &cloud.data[i * cloud.point_step + offset], sizeof z);
    if (!(z > 0.0F))
      continue;
    const double number = std::min(std::round(z * depth_scale), most);
    ++import.depths[static_cast<std::size_t>(number)];
    is_empty = false;
  }
  if (is_empty)
    ++import.empty;
}

} // namespace

std::uint64_t
RgbdImport::points() const
{
  return std::accumulate(depths.begin(), depths.end(), std::uint64_t{0});
}

std::uint16_t
RgbdImport::medianDepth() const
{
  std::uint64_t left = (points() + 1) / 2;
  std::size_t number = 0;
  while (number + 1 < depths.size() && depths[number] < left)
    left -= depths[number++];
  return static_cast<std::uint16_t>(number);
}

void
importFrame(const RgbdFrame& frame,
            bool has_poses,
            const RgbdCameras& cameras,
            const OutputFolder& folder,
            unsigned threads,
            RgbdImport& import)
{
  const Eigen::Isometry3d T_world_camera =
      has_poses ? loadPose(frame, cameras) : Eigen::Isometry3d::Identity();
  const RgbdObservation observation =
      loadRgbdObservation(frame, cameras, import.sizes, threads);
  const Eigen::Isometry3d T_map_camera = poseInMap(T_world_camera, import);
  saveObservation(folder.path(observationName(import.trajectory.poses.size())),
                  observation.cloud,
                  T_map_camera);
  countDepths(observation.cloud, cameras.meaning.scale, import);
  import.refined += observation.is_refined ? 1 : 0;
  import.sizes = observation.sizes;
  import.trajectory.stamps.push_back(frame.stamp);
  import.trajectory.poses.push_back(T_map_camera);
}

} // namespace pcl::acmap
