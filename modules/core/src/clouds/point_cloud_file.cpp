#include <pcl/core/point_cloud_file.h>

#include "clouds/coordinate_shift.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/core/impl/cloud_fields.h>

#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace pcl {

namespace acmap {
namespace {

/** \param[out] rows see \ref readPcd; stays empty for formats that have no such reader */
PointCloudFile
readFormat(const std::string& path,
           LargeVector<std::uint8_t>* rows,
           const CloudStatement& stated)
{
  ByteSource source(path);
  const std::string ending = lowerEnding(path);
  for (const char* text : {".xyz", ".txt", ".csv", ".asc", ".pts", ".xyzrgb", ".xyzn"})
    if (ending == text)
      return readText(source, ending == ".pts", stated);
  if (!stated.columns.empty())
    source.fail("names its own fields: --columns is for texts");
  if (ending == ".pcd")
    return readPcd(source, rows, stated);
  if (ending == ".ply")
    return readPly(source, rows, stated);
  if (ending == ".obj")
    return readObj(source, stated);
  if (ending == ".las")
    return readLas(source, rows, stated);
  if (ending == ".e57")
    return readE57(source, rows, stated);
  if (ending == ".ptx")
    return readPtx(source, rows, stated);
  if (ending == ".laz")
    source.fail(packedAdvice(path));
  source.fail(
      "ending '" + ending +
      "' is not known; pcd, ply, obj, xyz, txt, csv, asc, pts, ptx, las and e57 "
      "are");
}

/** Points that are (0, 0, 0) in a file whose others are far from there were not measured:
 * they become NaN. */
void
clearZeros(PointCloudFile& file, std::uint8_t* data)
{
  if (file.shift.isZero(0))
    return;
  const Eigen::Vector3f zero = (-file.shift).cast<float>();
  const Eigen::Vector3f nowhere =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  const std::size_t x = findField(file.cloud, "x")->offset;
  std::size_t cleared = 0;
  for (std::size_t i = 0; i < rowsOf(file.cloud); ++i) {
    std::uint8_t* const place = data + i * file.cloud.point_step + x;
    Eigen::Vector3f point;
    std::memcpy(point.data(), place, sizeof point);
    if (!isAt(point, zero))
      continue;
    std::memcpy(place, nowhere.data(), sizeof nowhere);
    ++cleared;
  }
  if (cleared == 0)
    return;
  file.cloud.is_dense = 0;
  file.remarks.push_back(std::to_string(cleared) +
                         " of its points are at (0, 0, 0), far "
                         "from the others, and were left out");
}

PointCloudFile
readAnyCloud(const std::string& path,
             LargeVector<std::uint8_t>* rows,
             const CloudStatement& stated)
{
  PointCloudFile file = readFormat(path, rows, stated);
  clearZeros(file,
             file.cloud.data.empty() && rows ? rows->data() : file.cloud.data.data());
  return file;
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
  return acmap::readAnyCloud(path, nullptr, {});
}

} // namespace pcl

namespace pcl::acmap {

std::string
packedAdvice(const std::string& path)
{
  return "is packed by LASzip; this unpacks it: pdal translate " + path + " " +
         path.substr(0, path.rfind('.')) + ".las";
}

namespace {

/** Takes a field of colours out of a cloud if all points are black, with a remark: some
 * programs declare colours that they do not have.
 * \param[in] data points of the cloud */
void
leaveOutBlackColors(PointCloudFile& file, const std::uint8_t* data)
{
  constexpr std::uint32_t without_alpha = 0x00ffffff;
  const PCLPointField* const color = findColor(file.cloud);
  const std::size_t points = rowsOf(file.cloud);
  if (!color || points == 0)
    return;
  for (std::size_t i = 0; i < points; ++i) {
    std::uint32_t packed = 0;
    std::memcpy(&packed, data + i * file.cloud.point_step + color->offset, 4);
    if ((packed & without_alpha) != 0)
      return;
  }
  file.remarks.emplace_back("its colours were left out: all points are black");
  file.cloud.fields.erase(file.cloud.fields.begin() +
                          (color - file.cloud.fields.data()));
}

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

PointCloudFile
loadStatedCloud(const std::string& path, const CloudStatement& stated)
{
  PointCloudFile file = readAnyCloud(path, nullptr, stated);
  scaleCloud(file, stated.scale);
  if (stated.without_black)
    leaveOutBlackColors(file, file.cloud.data.data());
  return file;
}

CloudRows
loadCloudRows(const std::string& path,
              const CloudStatement& stated,
              PointCloudFile& file)
{
  LargeVector<std::uint8_t> rows;
  PointCloudFile read = readAnyCloud(path, &rows, stated);
  if (rows.empty()) {
    std::vector<std::uint8_t>& data = read.cloud.data;
    rows.assign(data.begin(), data.end());
    std::vector<std::uint8_t>().swap(data);
  }
  scaleRows(read, rows.data(), stated.scale);
  if (stated.without_black)
    leaveOutBlackColors(read, rows.data());
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

} // namespace pcl::acmap
