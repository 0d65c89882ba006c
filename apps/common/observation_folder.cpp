#include "observation_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/point_cloud_writer.h>

#include <algorithm>

namespace pcl::acmap {

std::string
observationName(std::size_t index)
{
  constexpr std::size_t digits = 4;
  const std::string number = std::to_string(index);
  return "observation_" + std::string(digits - std::min(digits, number.size()), '0') +
         number + ".pcd";
}

bool
isSequenceName(const std::string& name)
{
  return name.rfind("observation_", 0) == 0 || name == trajectory_name;
}

void
requireNoSequence(const OutputFolder& folder, const std::vector<std::string>& more)
{
  for (const std::string& name : folder.names())
    if (isSequenceName(name) || std::count(more.begin(), more.end(), name) > 0)
      throw OutputFileException(folder.name() + ": already holds " + name +
                                "; name an empty or a new folder");
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
