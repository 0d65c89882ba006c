

#include <pcl/core/cloud_fields.h>
#include <pcl/core/scaled_cloud.h>

#include <cstring>

namespace pcl::acmap {

namespace {

/** Multiplies \a count adjacent float32 values of each point. */
void
scaleValues(PCLPointCloud2& cloud, std::size_t offset, std::size_t count, double scale)
{
  for (std::size_t row = 0; row < rowsOf(cloud); ++row)
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t* const place =
          &cloud.data[row * cloud.point_step + offset + i * sizeof(float)];
      float value = 0;
      std::memcpy(&value, place, sizeof value);
      value = static_cast<float>(value * scale);
      std::memcpy(place, &value, sizeof value);
    }
}

} // namespace

void
scaleCloud(PointCloudFile& file, double scale)
{
  if (scale == 1.0)
    return;
  if (const PCLPointField* const x = findField(file.cloud, "x"))
    scaleValues(file.cloud, x->offset, 3, scale);
  if (const auto* sigma = findField(file.cloud, "sigma", PCLPointField::FLOAT32))
    scaleValues(file.cloud, sigma->offset, 1, scale);
  file.sensor_origin = (file.sensor_origin.cast<double>() * scale).cast<float>();
}

PointCloudFile
loadScaledCloud(const std::string& path, double scale)
{
  PointCloudFile file = loadPointCloud(path);
  scaleCloud(file, scale);
  return file;
}

} // namespace pcl::acmap
