#include <pcl/core/point_cloud_file.h>

#include "byte_source.h"
#include "point_cloud_readers.h"
#include "text_number.h"

#include <pcl/core/impl/cloud_fields.h>

#include <cstring>

namespace pcl {

acmap::PointView
PointCloudFile::points() const
{
  const PCLPointField* const x = acmap::findField(cloud, "x");
  if (!x || cloud.data.empty())
    return {};
  return {cloud.data.data() + x->offset, cloud.point_step, acmap::rowsOf(cloud)};
}

PointCloudFile
loadPointCloud(const std::string& path)
{
  acmap::ByteSource source(path);
  const std::string ending = acmap::lowerEnding(path);
  if (ending == ".pcd")
    return acmap::readPcd(source);
  if (ending == ".ply")
    return acmap::readPly(source);
  if (ending == ".obj")
    return acmap::readObj(source);
  if (ending == ".xyz")
    return acmap::readXyz(source);
  if (ending == ".las")
    return acmap::readLas(source);
  if (ending == ".e57")
    return acmap::readE57(source);
  if (ending == ".laz")
    source.fail("is packed by LASzip; laszip or pdal translate unpacks it to .las");
  source.fail("ending '" + ending +
              "' is not known; pcd, ply, obj, xyz, las and e57 are");
}

} // namespace pcl

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
  file.shift *= scale;
  for (Eigen::Vector3f& viewpoint : file.viewpoints)
    viewpoint *= static_cast<float>(scale);
}

PointCloudFile
loadScaledCloud(const std::string& path, double scale)
{
  PointCloudFile file = loadPointCloud(path);
  scaleCloud(file, scale);
  return file;
}

} // namespace pcl::acmap
