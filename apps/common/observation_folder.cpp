#include "observation_folder.h"

#include "output_target.h"

#include <pcl/core/point_cloud_writer.h>

#include <algorithm>

namespace pcl::acmap {

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
  return name.rfind("observation_", 0) == 0 || name == trajectory_name;
}

void
requireNoSequence(const OutputFolder& folder, const std::vector<std::string>& more)
{
  requireNoneIn(folder, [&](const std::string& name) {
    return isSequenceName(name) || std::count(more.begin(), more.end(), name) > 0;
  });
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
