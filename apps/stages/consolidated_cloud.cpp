#include "consolidated_cloud.h"

#include <pcl/core/cloud_fields.h>

#include <array>
#include <cstring>

namespace pcl::acmap {

namespace {

constexpr std::array<const char*, 3> normal_names = {
    "normal_x", "normal_y", "normal_z"};

ColorView
colorsOfFile(const PointCloudFile& file)
{
  const PCLPointField* color = findColor(file.cloud);
  if (!color)
    return {};
  return {file.cloud.data.data() + color->offset, file.cloud.point_step};
}

/** The fields of the input, and those of a normal where they were missing. */
PCLPointCloud2
emptyResult(const PCLPointCloud2& cloud, std::size_t size)
{
  std::vector<FieldWish> wishes;
  for (const char* name : normal_names)
    wishes.push_back({name, PCLPointField::FLOAT32});
  wishes.push_back({"curvature", PCLPointField::FLOAT32});
  PCLPointCloud2 result = layoutWith(cloud, wishes);
  resizeRows(result, size);
  result.is_dense = 1;
  return result;
}

class RowWriter {
public:
  explicit RowWriter(const PCLPointCloud2& cloud)
  : place_(findField(cloud, "x")->offset)
  , sigma_(findField(cloud, "sigma", PCLPointField::FLOAT32))
  , color_(findColor(cloud))
  , curvature_(findField(cloud, "curvature")->offset)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      normal_[axis] = findField(cloud, normal_names[axis])->offset;
  }

  void
  write(const Representative& from, float sigma, std::uint8_t* row) const
  {
    std::memcpy(row + place_, from.point.data(), 3 * sizeof(float));
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(row + normal_[axis], from.normal.data() + axis, sizeof(float));
    std::memcpy(row + curvature_, &from.curvature, sizeof(float));
    if (sigma_)
      std::memcpy(row + sigma_->offset, &sigma, sizeof sigma);
    if (color_)
      for (std::size_t channel = 0; channel < 3; ++channel) // packed blue first
        row[color_->offset + 2 - channel] = from.color[channel];
  }

private:
  std::size_t place_;
  const PCLPointField* sigma_;
  const PCLPointField* color_;
  std::size_t curvature_;
  std::array<std::size_t, 3> normal_{};
};

} // namespace

ConsolidatedCloud
consolidatedCloud(const PointCloudFile& file,
                  const SensorView& sensors,
                  const ConsolidationSettings& settings,
                  const ProgressCallback& progress,
                  ConsolidationReport& report)
{
  ConsolidatedCloud result;
  result.consolidation = consolidatePoints(
      file.points(), sensors, colorsOfFile(file), settings, Progress(progress), report);
  const std::vector<Representative>& all = result.consolidation.representatives;
  result.file.sensor_origin = file.sensor_origin;
  result.file.sensor_orientation = file.sensor_orientation;
  result.file.remarks = file.remarks;
  result.file.cloud = emptyResult(file.cloud, all.size());
  const RowWriter writer(result.file.cloud);
  std::uint8_t* row = result.file.cloud.data.data();
  for (const Representative& representative : all) {
    std::memcpy(row,
                file.cloud.data.data() +
                    static_cast<std::size_t>(representative.witness) *
                        file.cloud.point_step,
                file.cloud.point_step);
    writer.write(representative, static_cast<float>(report.residual), row);
    row += result.file.cloud.point_step;
  }
  return result;
}

} // namespace pcl::acmap
