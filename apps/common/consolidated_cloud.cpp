#include "consolidated_cloud.h"

#include <pcl/core/trajectory.h>
#include <pcl/filters/consolidation_kernel.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {

namespace {

const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name)
{
  const auto found =
      std::find_if(cloud.fields.begin(),
                   cloud.fields.end(),
                   [&](const PCLPointField& field) { return field.name == name; });
  return found == cloud.fields.end() ? nullptr : &*found;
}

const PCLPointField*
findColor(const PCLPointCloud2& cloud)
{
  const PCLPointField* rgb = findField(cloud, "rgb");
  return rgb ? rgb : findField(cloud, "rgba");
}

std::vector<Eigen::Vector3f>
viewpointsBeside(const std::string& path, double scale, ConsolidationReport& report)
{
  const auto trajectory =
      std::filesystem::path(path).replace_filename("trajectory.txt");
  std::vector<Eigen::Vector3f> viewpoints;
  if (!std::filesystem::exists(trajectory)) {
    report.remarks.push_back("no " + trajectory.string() +
                             ": the points name their views, but where these stood is "
                             "unknown");
    return viewpoints;
  }
  for (const Eigen::Isometry3d& pose : loadTrajectory(trajectory.string()).poses)
    viewpoints.push_back((pose.translation() * scale).cast<float>());
  return viewpoints;
}

SensorView
sensorsOfFile(const PointCloudFile& file,
              const std::string& path,
              double scale,
              ConsolidationReport& report)
{
  const PCLPointField* view = findField(file.cloud, "view");
  if (!view || view->datatype != PCLPointField::INT32)
    return SensorView(file.sensor_origin);
  return SensorView(file.cloud.data.data() + view->offset,
                    file.cloud.point_step,
                    viewpointsBeside(path, scale, report));
}

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
  PCLPointCloud2 result;
  result.header = cloud.header;
  result.fields = cloud.fields;
  result.point_step = cloud.point_step;
  for (const char* name : {"normal_x", "normal_y", "normal_z", "curvature"}) {
    const PCLPointField* field = findField(result, name);
    if (field && field->datatype == PCLPointField::FLOAT32)
      continue;
    if (field)
      result.fields.erase(result.fields.begin() + (field - result.fields.data()));
    PCLPointField added;
    added.name = name;
    added.offset = result.point_step;
    added.datatype = PCLPointField::FLOAT32;
    added.count = 1;
    result.fields.push_back(added);
    result.point_step += sizeof(float);
  }
  result.height = 1;
  result.width = static_cast<std::uint32_t>(size);
  result.row_step = result.width * result.point_step;
  result.data.resize(size * result.point_step);
  result.is_dense = 1;
  return result;
}

class RowWriter {
public:
  explicit RowWriter(const PCLPointCloud2& cloud)
  : place_(offsetOf(cloud, "x"))
  , sigma_(findField(cloud, "sigma"))
  , color_(findColor(cloud))
  , curvature_(offsetOf(cloud, "curvature"))
  {
    normal_ = {offsetOf(cloud, "normal_x"),
               offsetOf(cloud, "normal_y"),
               offsetOf(cloud, "normal_z")};
  }

  void
  write(const Representative& from, float sigma, std::uint8_t* row) const
  {
    std::memcpy(row + place_, from.point.data(), 3 * sizeof(float));
    for (int axis = 0; axis < 3; ++axis)
      std::memcpy(row + normal_[static_cast<std::size_t>(axis)],
                  &from.normal[axis],
                  sizeof(float));
    std::memcpy(row + curvature_, &from.curvature, sizeof(float));
    if (sigma_ && sigma_->datatype == PCLPointField::FLOAT32)
      std::memcpy(row + sigma_->offset, &sigma, sizeof sigma);
    if (color_)
      for (int channel = 0; channel < 3; ++channel) // packed blue first
        row[color_->offset + static_cast<std::size_t>(2 - channel)] =
            from.color[static_cast<std::size_t>(channel)];
  }

private:
  static std::size_t
  offsetOf(const PCLPointCloud2& cloud, const std::string& name)
  {
    return findField(cloud, name)->offset;
  }

  std::size_t place_;
  const PCLPointField* sigma_;
  const PCLPointField* color_;
  std::size_t curvature_;
  std::array<std::size_t, 3> normal_{};
};

} // namespace

PointCloudFile
consolidatedCloud(const PointCloudFile& file,
                  const std::string& path,
                  const CloudConsolidation& settings,
                  const ProgressCallback& progress,
                  ConsolidationReport& report)
{
  ConsolidationReport about_sensors;
  const SensorView sensors = sensorsOfFile(file, path, settings.scale, about_sensors);
  ConsolidationSettings kernel_settings;
  kernel_settings.voxel_size = settings.voxel_size;
  kernel_settings.threads = settings.threads;
  const Consolidation consolidation = consolidatePoints(file.points(),
                                                        sensors,
                                                        colorsOfFile(file),
                                                        kernel_settings,
                                                        Progress(progress),
                                                        report);
  report.remarks.insert(report.remarks.begin(),
                        about_sensors.remarks.begin(),
                        about_sensors.remarks.end());

  PointCloudFile result;
  result.sensor_origin = file.sensor_origin;
  result.sensor_orientation = file.sensor_orientation;
  result.cloud = emptyResult(file.cloud, consolidation.representatives.size());
  const RowWriter writer(result.cloud);
  std::uint8_t* row = result.cloud.data.data();
  for (const Representative& representative : consolidation.representatives) {
    std::memcpy(row,
                file.cloud.data.data() +
                    static_cast<std::size_t>(representative.witness) *
                        file.cloud.point_step,
                file.cloud.point_step);
    writer.write(representative, static_cast<float>(report.residual), row);
    row += result.cloud.point_step;
  }
  return result;
}

} // namespace pcl::acmap
