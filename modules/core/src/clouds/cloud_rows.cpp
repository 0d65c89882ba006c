#include <pcl/core/cloud_rows.h>
#include <pcl/core/exceptions.h>

#include <string>
#include <utility>

namespace pcl {

CloudRows::CloudRows(const PCLPointCloud2ConstPtr& cloud)
: layout_(cloud)
, rows_(cloud)
, data_(cloud ? cloud->data.data() : nullptr)
, bytes_(cloud ? cloud->data.size() : 0)
{}

CloudRows::CloudRows(PCLPointCloud2 layout, LargeVector<std::uint8_t> rows)
{
  if (layout.point_step == 0 || rows.size() % layout.point_step != 0)
    throw acmap::BadArgument(std::to_string(rows.size()) +
                             " bytes are no rows of a point of " +
                             std::to_string(layout.point_step));
  layout.data.clear();
  const std::size_t points = rows.size() / layout.point_step;
  if (std::size_t{layout.width} * layout.height != points) {
    layout.height = 1;
    layout.width = static_cast<uindex_t>(points);
  }
  layout.row_step = layout.width * layout.point_step;
  layout_ = std::make_shared<const PCLPointCloud2>(std::move(layout));
  const auto kept = std::make_shared<const LargeVector<std::uint8_t>>(std::move(rows));
  data_ = kept->data();
  bytes_ = kept->size();
  rows_ = kept;
}

PCLPointCloud2
CloudRows::copy() const
{
  PCLPointCloud2 cloud = layout();
  cloud.data.assign(data_, data_ + bytes_);
  return cloud;
}

} // namespace pcl
