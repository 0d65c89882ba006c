#include "cloud_labels.h"

#include "exit_code.h"

#include <pcl/common/colors.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/trajectory.h>

#include <filesystem>

namespace pcl::acmap {

namespace {

std::uint32_t
packedColor(std::uint32_t label)
{
  constexpr std::uint32_t grey = 0xffb4b4b4;
  if (label == 0)
    return grey;
  return GlasbeyLUT::at((label - 1) % GlasbeyLUT::size()).rgba;
}

} // namespace

PCLPointCloud2
withLabels(PCLPointCloud2 cloud, const std::vector<std::int32_t>& planes)
{
  cloud = withFields(std::move(cloud), {{"label", PCLPointField::UINT32}});
  const std::size_t offset = findField(cloud, "label")->offset;
  for (std::size_t row = 0; row < planes.size(); ++row)
    setValue(cloud, row, offset, static_cast<std::uint32_t>(planes[row] + 1));
  return cloud;
}

PCLPointCloud2
coloredByLabel(PCLPointCloud2 cloud)
{
  if (!findField(cloud, "label", PCLPointField::UINT32))
    throw UsageError("the points have no field label to be coloured by");
  if (!findColor(cloud))
    cloud = withFields(std::move(cloud), {{"rgb", PCLPointField::FLOAT32}});
  const std::size_t color = findColor(cloud)->offset;
  const std::size_t place = findField(cloud, "label")->offset;
  for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
    std::uint32_t label = 0;
    std::memcpy(&label, &cloud.data[row * cloud.point_step + place], sizeof label);
    setValue(cloud, row, color, packedColor(label));
  }
  return cloud;
}

std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 StageLog& log)
{
  std::vector<Eigen::Vector3f> viewpoints;
  if (!findField(file.cloud, "view", PCLPointField::INT32) || !file.viewpoints.empty())
    return file.viewpoints;
  const auto trajectory =
      std::filesystem::path(path).replace_filename("trajectory.txt");
  if (!std::filesystem::exists(trajectory))
    log.warn("no " + trajectory.string() +
             ": the points name their views, but where these stood is unknown");
  else
    for (const Eigen::Isometry3d& pose : loadTrajectory(trajectory.string()).poses)
      viewpoints.push_back((pose.translation() * scale).cast<float>());
  return viewpoints;
}

} // namespace pcl::acmap
