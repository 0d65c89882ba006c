#include "cloud_sensors.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/trajectory.h>

#include <filesystem>

namespace pcl::acmap {

namespace {

std::vector<Eigen::Vector3f>
viewpointsBeside(const std::string& path,
                 double scale,
                 std::vector<std::string>& remarks)
{
  const auto trajectory =
      std::filesystem::path(path).replace_filename("trajectory.txt");
  std::vector<Eigen::Vector3f> viewpoints;
  if (!std::filesystem::exists(trajectory)) {
    remarks.push_back("no " + trajectory.string() +
                      ": the points name their views, but where these stood is "
                      "unknown");
    return viewpoints;
  }
  for (const Eigen::Isometry3d& pose : loadTrajectory(trajectory.string()).poses)
    viewpoints.push_back((pose.translation() * scale).cast<float>());
  return viewpoints;
}

} // namespace

std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 std::vector<std::string>& remarks)
{
  if (!findField(file.cloud, "view", PCLPointField::INT32))
    return {};
  return viewpointsBeside(path, scale, remarks);
}

} // namespace pcl::acmap
