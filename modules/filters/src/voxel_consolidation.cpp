#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/filters/impl/consolidation_kernel.h>
#include <pcl/filters/impl/voxel_consolidation.hpp>

#include <cstring>

namespace pcl {

void
ConsolidationParameters::setVoxelSize(double size)
{
  acmap::requireInRange("voxel size", size, 0.0, 1e9, "m (0 = automatic)");
  settings_.voxel_size = size;
}

void
ConsolidationParameters::setViewpoints(std::vector<Eigen::Vector3f> viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  viewpoints_ = std::move(viewpoints);
}

acmap::ConsolidationSettings
ConsolidationParameters::settings() const
{
  acmap::ConsolidationSettings settings = settings_;
  settings.threads = threads_;
  return settings;
}

namespace {

using acmap::FieldWish;
using acmap::Representative;

/** The fields of the input, and those of a normal if they are missing. */
PCLPointCloud2
layoutOfResult(const PCLPointCloud2& cloud, const ConsolidationReport& report)
{
  std::vector<FieldWish> wishes;
  for (const char* name : acmap::normal_field_names)
    wishes.push_back({name, PCLPointField::FLOAT32});
  wishes.push_back({"curvature", PCLPointField::FLOAT32});
  PCLPointCloud2 result = acmap::layoutWith(cloud, wishes);
  result.is_dense = report.without_normal == 0;
  return result;
}

class RowWriter {
public:
  explicit RowWriter(const PCLPointCloud2& cloud)
  : position_(acmap::findField(cloud, "x")->offset)
  , sigma_(acmap::findField(cloud, "sigma", PCLPointField::FLOAT32))
  , color_(acmap::findColor(cloud))
  , curvature_(acmap::findField(cloud, "curvature")->offset)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      normal_[axis] = acmap::findField(cloud, acmap::normal_field_names[axis])->offset;
  }

  void
  write(const Representative& from, float sigma, std::uint8_t* row) const
  {
    std::memcpy(row + position_, from.point.data(), 3 * sizeof(float));
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(row + normal_[axis], from.normal.data() + axis, sizeof(float));
    std::memcpy(row + curvature_, &from.curvature, sizeof(float));
    if (sigma_)
      std::memcpy(row + sigma_->offset, &sigma, sizeof sigma);
    if (color_)
      for (std::size_t channel = 0; channel < 3; ++channel) // blue is packed first
        row[color_->offset + 2 - channel] = from.color[channel];
  }

private:
  std::size_t position_;
  const PCLPointField* sigma_;
  const PCLPointField* color_;
  std::size_t curvature_;
  std::size_t normal_[3] = {};
};

} // namespace

VoxelConsolidation<PCLPointCloud2>::VoxelConsolidation()
{
  filter_name_ = "VoxelConsolidation";
}

void
VoxelConsolidation<PCLPointCloud2>::setInputCloud(const PCLPointCloud2ConstPtr& cloud)
{
  acmap::requireGiven(cloud);
  Filter<PCLPointCloud2>::setInputCloud(cloud);
  rows_ = CloudRows();
}

void
VoxelConsolidation<PCLPointCloud2>::setSensorOrigin(const Eigen::Vector3f& origin)
{
  acmap::requireViewpoints({origin});
  sensor_origin_ = origin;
}

void
VoxelConsolidation<PCLPointCloud2>::filter(PCLPointCloud2& output)
{
  applyFilter(output);
}

void
VoxelConsolidation<PCLPointCloud2>::applyFilter(PCLPointCloud2& output)
{
  PCLPointCloud2 result;
  consolidate([&](const PCLPointCloud2& layout, std::size_t points) {
    result = layout;
    acmap::resizeRows(result, points);
    return result.data.data();
  });
  output = std::move(result);
}

void
VoxelConsolidation<PCLPointCloud2>::filter(CloudRows& output)
{
  PCLPointCloud2 layout;
  LargeVector<std::uint8_t> rows;
  consolidate([&](const PCLPointCloud2& of_result, std::size_t points) {
    layout = of_result;
    rows.resize(points * layout.point_step);
    return rows.data();
  });
  output = CloudRows(std::move(layout), std::move(rows));
}

void
VoxelConsolidation<PCLPointCloud2>::consolidate(const MakeRows& make)
{
  const bool is_subset = !rows_ && !fake_indices_;
  const Indices* const wanted = is_subset ? indices_.get() : nullptr;
  const CloudRows rows = rows_ ? rows_ : CloudRows(input_);
  const acmap::PointView points = acmap::requirePoints(rows, wanted);
  ConsolidationReport report;
  const acmap::Consolidation consolidation = acmap::consolidatePoints(
      points,
      acmap::sensorsOf(rows, viewpoints_, sensor_origin_, wanted),
      acmap::colorsOf(rows),
      settings(),
      acmap::Progress(progress_),
      report);

  const std::size_t step = rows.layout().point_step;
  const PCLPointCloud2 layout = layoutOfResult(rows.layout(), report);
  const RowWriter writer(layout);
  std::uint8_t* const made = make(layout, consolidation.representatives.size());
  const auto writeRows = [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const Representative& representative = consolidation.representatives[r];
      const auto witness = static_cast<std::size_t>(
          points.index(static_cast<std::size_t>(representative.witness)));
      std::uint8_t* const row = made + r * layout.point_step;
      std::memcpy(row, rows.data() + witness * step, step);
      writer.write(representative, static_cast<float>(report.residual), row);
    }
  };
  acmap::withThreads(threads_, [&] {
    acmap::parallelForChunks(consolidation.representatives.size(), writeRows);
  });
  Indices voxel_of_point;
  if (getKeepSources()) {
    voxel_of_point.assign(rows.size(), -1);
    for (std::size_t i = 0; i < consolidation.representative_of.size(); ++i)
      voxel_of_point[static_cast<std::size_t>(points.index(i))] =
          consolidation.representative_of[i];
  }
  voxel_of_point_ = std::move(voxel_of_point);
  report_ = std::move(report);
}

} // namespace pcl

PCL_INSTANTIATE(VoxelConsolidation, ACMAP_ALL_POINT_TYPES)
