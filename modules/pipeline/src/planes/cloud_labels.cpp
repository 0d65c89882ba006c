#include <pcl/common/colors.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/cloud_labels.h>

#include <cstring>
#include <utility>

namespace pcl::acmap {

namespace {

std::uint32_t
colorOfLabel(std::uint32_t label)
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
  if (planes.size() != rowsOf(cloud))
    throw BadArgument(
        "there are ", planes.size(), " labels for ", rowsOf(cloud), " points");
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
    throw BadArgument("the points have no field label to be coloured by");
  if (!findColor(cloud))
    cloud = withFields(std::move(cloud), {{"rgb", PCLPointField::FLOAT32}});
  const std::size_t color = findColor(cloud)->offset;
  const std::size_t place = findField(cloud, "label")->offset;
  for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
    std::uint32_t label = 0;
    std::memcpy(&label, &cloud.data[row * cloud.point_step + place], sizeof label);
    setValue(cloud, row, color, colorOfLabel(label));
  }
  return cloud;
}

} // namespace pcl::acmap
