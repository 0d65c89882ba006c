#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/map_rows.h>

#include <cstring>
#include <utility>

namespace pcl::acmap {

namespace {

std::vector<FieldWish>
fieldsOf(bool colored)
{
  std::vector<FieldWish> fields = {{"x", PCLPointField::FLOAT32},
                                   {"y", PCLPointField::FLOAT32},
                                   {"z", PCLPointField::FLOAT32}};
  if (colored)
    fields.push_back({"rgb", PCLPointField::FLOAT32});
  fields.push_back({"view", PCLPointField::INT32});
  return fields;
}

/** \return number of rows that were moved to the front of \a to, which may be the data
 * of the cloud itself */
std::size_t
moveEveryNth(const PCLPointCloud2& cloud, std::size_t n, std::vector<std::uint8_t>& to)
{
  const std::size_t rows = cloud.data.size() / cloud.point_step;
  std::size_t kept = 0;
  for (std::size_t row = 0; row < rows; row += n, ++kept)
    std::memmove(&to[kept * cloud.point_step],
                 &cloud.data[row * cloud.point_step],
                 cloud.point_step);
  return kept;
}

} // namespace

MapRows::MapRows(std::size_t points, bool colored, CostCallback cost)
: cloud_(layoutWith(PCLPointCloud2(), fieldsOf(colored)))
, colored_(colored)
, cost_(std::move(cost))
, announced_(points * cloud_.point_step)
{
  announce(announced_);
  cloud_.data.reserve(announced_);
}

void
MapRows::announce(std::size_t bytes) const
{
  if (cost_ && bytes > 0)
    cost_("merging the observations", bytes, 0);
}

void
MapRows::append(const PointCloudFile& observation,
                const Eigen::Isometry3d& T_map_camera,
                std::int32_t view)
{
  const PointView points = observation.points();
  const std::size_t bytes = cloud_.data.size() + points.size() * cloud_.point_step;
  if (bytes > announced_)
    announce(bytes);
  const PCLPointField* const color = colored_ ? findColor(observation.cloud) : nullptr;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite() || seen_++ % every_ != 0)
      continue;
    const Eigen::Vector3f place = (T_map_camera * point.cast<double>()).cast<float>();
    const std::size_t row = cloud_.data.size();
    cloud_.data.resize(row + cloud_.point_step);
    std::uint8_t* const to = &cloud_.data[row];
    std::memcpy(to, place.data(), 3 * sizeof(float));
    if (color)
      std::memcpy(
          to + 3 * sizeof(float),
          &observation.cloud.data[i * observation.cloud.point_step + color->offset],
          sizeof(std::uint32_t));
    std::memcpy(to + cloud_.point_step - sizeof view, &view, sizeof view);
  }
  while (cloud_.data.size() / cloud_.point_step > maximum_) {
    cloud_.data.resize(moveEveryNth(cloud_, 2, cloud_.data) * cloud_.point_step);
    every_ *= 2;
  }
}

PCLPointCloud2
MapRows::finish()
{
  resizeRows(cloud_, cloud_.data.size() / cloud_.point_step);
  return std::move(cloud_);
}

PCLPointCloud2
everyNth(const PCLPointCloud2& cloud, std::size_t n)
{
  const std::size_t rows = cloud.data.size() / cloud.point_step;
  PCLPointCloud2 thinned = layoutWith(cloud, {});
  resizeRows(thinned, (rows + n - 1) / n);
  moveEveryNth(cloud, n, thinned.data);
  return thinned;
}

} // namespace pcl::acmap
