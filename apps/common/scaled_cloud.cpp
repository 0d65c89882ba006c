#include "scaled_cloud.h"

#include <cstring>

namespace pcl::acmap {

void
scaleCloud(PointCloudFile& file, double scale)
{
  if (scale == 1.0)
    return;
  std::size_t offset = 0;
  for (const PCLPointField& field : file.cloud.fields)
    if (field.name == "x")
      offset = field.offset;
  const std::size_t size =
      static_cast<std::size_t>(file.cloud.width) * file.cloud.height;
  for (std::size_t i = 0; i < size; ++i) {
    std::uint8_t* const place =
        file.cloud.data.data() + i * file.cloud.point_step + offset;
    Eigen::Vector3f p;
    std::memcpy(p.data(), place, sizeof(float) * 3);
    p = (p.cast<double>() * scale).cast<float>();
    std::memcpy(place, p.data(), sizeof(float) * 3);
  }
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
