#include <pcl/core/point_cloud_file.h>

#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/core/impl/cloud_fields.h>

#include <cstring>
#include <utility>
#include <vector>

namespace pcl {

namespace acmap {
namespace {

/** \param[out] rows see \ref readPcd; stays empty for formats that have no such reader */
PointCloudFile
readAnyCloud(const std::string& path, LargeVector<std::uint8_t>* rows)
{
  ByteSource source(path);
  const std::string ending = lowerEnding(path);
  if (ending == ".pcd")
    return readPcd(source, rows);
  if (ending == ".ply")
    return readPly(source, rows);
  if (ending == ".obj")
    return readObj(source);
  if (ending == ".xyz")
    return readXyz(source);
  if (ending == ".las")
    return readLas(source, rows);
  if (ending == ".e57")
    return readE57(source, rows);
  if (ending == ".laz")
    source.fail("is packed by LASzip; laszip or pdal translate unpacks it to .las");
  source.fail("ending '" + ending +
              "' is not known; pcd, ply, obj, xyz, las and e57 are");
}

} // namespace
} // namespace acmap

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
  return acmap::readAnyCloud(path, nullptr);
}

} // namespace pcl

namespace pcl::acmap {

namespace {

/** Multiplies \a count adjacent float32 values of each point.
 * \param[in,out] data rows of the cloud */
void
scaleValues(const PCLPointCloud2& cloud,
            std::uint8_t* data,
            std::size_t offset,
            std::size_t count,
            double scale)
{
  for (std::size_t row = 0; row < rowsOf(cloud); ++row)
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t* const place =
          data + row * cloud.point_step + offset + i * sizeof(float);
      float value = 0;
      std::memcpy(&value, place, sizeof value);
      value = static_cast<float>(value * scale);
      std::memcpy(place, &value, sizeof value);
    }
}

/** \param[in,out] data rows of the cloud of the file */
void
scaleRows(PointCloudFile& file, std::uint8_t* data, double scale)
{
  if (scale == 1.0)
    return;
  if (const PCLPointField* const x = findField(file.cloud, "x"))
    scaleValues(file.cloud, data, x->offset, 3, scale);
  if (const auto* sigma = findField(file.cloud, "sigma", PCLPointField::FLOAT32))
    scaleValues(file.cloud, data, sigma->offset, 1, scale);
  file.sensor_origin = (file.sensor_origin.cast<double>() * scale).cast<float>();
  file.shift *= scale;
  for (Eigen::Vector3f& viewpoint : file.viewpoints)
    viewpoint *= static_cast<float>(scale);
}

} // namespace

void
scaleCloud(PointCloudFile& file, double scale)
{
  scaleRows(file, file.cloud.data.data(), scale);
}

CloudRows
loadCloudRows(const std::string& path, double scale, PointCloudFile& file)
{
  LargeVector<std::uint8_t> rows;
  PointCloudFile read = readAnyCloud(path, &rows);
  if (rows.empty()) {
    std::vector<std::uint8_t>& data = read.cloud.data;
    rows.assign(data.begin(), data.end());
    std::vector<std::uint8_t>().swap(data);
  }
  scaleRows(read, rows.data(), scale);
  file = std::move(read);
  return CloudRows(file.cloud, std::move(rows));
}

SensorEvidence
sensorEvidence(const CloudRows& rows, const PointCloudFile& file)
{
  const bool has_pose =
      !file.sensor_origin.isZero(0) ||
      !file.sensor_orientation.isApprox(Eigen::Quaternionf::Identity());
  SensorEvidence result;
  result.confidence = 1;
  if (file.sensor_statement == SensorStatement::NoSensor) {
    result.evidence = "stated: no single sensor";
    return result;
  }
  if (has_pose || file.sensor_statement == SensorStatement::Stated) {
    result.outcome = SensorOutcome::Stated;
    result.evidence = "stated";
    return result;
  }
  const PCLPointCloud2& layout = rows.layout();
  return assessSensor(requirePoints(rows),
                      layout.height > 1 ? layout.width : 0,
                      file.sensor_origin.cast<double>());
}

PointCloudFile
loadScaledCloud(const std::string& path, double scale)
{
  PointCloudFile file = loadPointCloud(path);
  scaleCloud(file, scale);
  return file;
}

} // namespace pcl::acmap
