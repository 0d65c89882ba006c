#include "byte_source.h"
#include "coordinate_shift.h"
#include "point_cloud_readers.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief What a point data record format of LAS 1.0 to 1.4 has, offsets in bytes. */
struct LasRecord {
  std::size_t bytes;
  std::size_t classification;
  std::size_t color; ///< 0: none
};

constexpr std::array<LasRecord, 11> las_records = {{{20, 15, 0},
                                                    {28, 15, 0},
                                                    {26, 15, 20},
                                                    {34, 15, 28},
                                                    {57, 15, 0},
                                                    {63, 15, 28},
                                                    {30, 16, 0},
                                                    {36, 16, 30},
                                                    {38, 16, 30},
                                                    {59, 16, 0},
                                                    {67, 16, 30}}};

/** \brief A value of a little-endian file. */
template <typename Value>
Value
valueAt(const char* bytes, std::size_t offset)
{
  Value value;
  std::memcpy(&value, bytes + offset, sizeof value);
  return value;
}

struct LasHeader {
  std::uint64_t header_bytes = 0, first_point = 0, points = 0;
  std::size_t format = 0, record_bytes = 0;
  Eigen::Vector3d scale, offset;
};

/** \throws InputFileException for what is no LAS file, or packed */
LasHeader
readLasHeader(ByteSource& source)
{
  constexpr std::size_t shortest = 227, of_1_4 = 375;
  std::array<char, of_1_4> bytes{};
  if (source.remaining() < shortest)
    source.fail("is shorter than the header of a LAS file");
  source.read(bytes.data(), shortest);
  if (std::memcmp(bytes.data(), "LASF", 4) != 0)
    source.fail("is no LAS file: it does not begin with LASF");
  const int major = bytes[24], minor = bytes[25];
  if (major != 1 || minor < 0 || minor > 4)
    source.fail("is LAS " + std::to_string(major) + "." + std::to_string(minor) +
                ", 1.0 to 1.4 are read");
  LasHeader header;
  header.header_bytes = shortest;
  const bool is_1_4 = minor == 4 && valueAt<std::uint16_t>(bytes.data(), 94) >= of_1_4;
  if (is_1_4) {
    if (source.remaining() < of_1_4 - shortest)
      source.fail("is shorter than its header");
    source.read(bytes.data() + shortest, of_1_4 - shortest);
    header.header_bytes = of_1_4;
  }
  header.first_point = valueAt<std::uint32_t>(bytes.data(), 96);
  const auto format = static_cast<std::uint8_t>(bytes[104]);
  constexpr std::uint8_t packed = 0xC0; // bits that LASzip sets
  if ((format & packed) != 0)
    source.fail("is packed by LASzip; laszip or pdal translate unpacks it to .las");
  if (format >= las_records.size())
    source.fail("has points of format " + std::to_string(format) +
                ", 0 to 10 are known");
  header.format = format;
  header.record_bytes = valueAt<std::uint16_t>(bytes.data(), 105);
  if (header.record_bytes < las_records[header.format].bytes)
    source.fail("claims points of " + std::to_string(header.record_bytes) +
                " bytes, those of format " + std::to_string(format) + " have " +
                std::to_string(las_records[header.format].bytes));
  header.points = valueAt<std::uint32_t>(bytes.data(), 107);
  if (const auto count = valueAt<std::uint64_t>(bytes.data(), 247); is_1_4 && count > 0)
    header.points = count;
  for (int axis = 0; axis < 3; ++axis) {
    header.scale[axis] = valueAt<double>(bytes.data(), 131 + 8 * axis);
    header.offset[axis] = valueAt<double>(bytes.data(), 155 + 8 * axis);
  }
  if (!header.scale.allFinite() || !header.offset.allFinite() ||
      (header.scale.array() == 0).any())
    source.fail("has a scale or an offset that is no number");
  if (header.first_point < header.header_bytes)
    source.fail("claims points within its header");
  return header;
}

Eigen::Vector3d
placeOf(const char* record, const LasHeader& header)
{
  const Eigen::Vector3d steps(valueAt<std::int32_t>(record, 0),
                              valueAt<std::int32_t>(record, 4),
                              valueAt<std::int32_t>(record, 8));
  return steps.cwiseProduct(header.scale) + header.offset;
}

std::vector<SourceField>
lasFields(bool has_color)
{
  std::vector<SourceField> fields;
  for (const char* name : {"x", "y", "z", "intensity"})
    fields.push_back({name, PCLPointField::FLOAT32, 1, 0});
  if (has_color)
    fields.push_back({"rgb", PCLPointField::FLOAT32, 1, 0});
  fields.push_back({"classification", PCLPointField::UINT8, 1, 0});
  return fields;
}

using Color16 = std::array<std::uint16_t, 3>;

/** \brief Packs colours of 16 bits, or of 8 where none of them needs more. */
void
storeColors(const std::vector<Color16>& colors,
            std::size_t offset,
            PCLPointCloud2& cloud)
{
  std::uint16_t largest = 0;
  for (const Color16& color : colors)
    largest = std::max({largest, color[0], color[1], color[2]});
  const int shift = largest > 255 ? 8 : 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    std::uint8_t* const to = &cloud.data[i * cloud.point_step + offset];
    for (std::size_t c = 0; c < 3; ++c)
      to[2 - c] = static_cast<std::uint8_t>(colors[i][c] >> shift);
  }
}

} // namespace

PointCloudFile
readLas(ByteSource& source)
{
  const LasHeader header = readLasHeader(source);
  if (source.remaining() < header.first_point - header.header_bytes)
    source.fail("ends before its points");
  source.skip(header.first_point - header.header_bytes);
  requirePointsFit(header.points, header.record_bytes, source);
  const LasRecord& record = las_records[header.format];
  PointCloudFile file;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  const FieldLayout layout = planLayout(lasFields(record.color > 0), source);
  const auto count = static_cast<std::size_t>(header.points);
  shapeCloud(file.cloud, layout, count, 1);
  const std::size_t color_offset = 4 * sizeof(float);
  std::vector<Color16> colors;
  std::vector<char> bytes(header.record_bytes);
  for (std::size_t i = 0; i < count; ++i) {
    source.read(bytes.data(), bytes.size());
    const Eigen::Vector3d place = placeOf(bytes.data(), header);
    if (i == 0)
      shift = coordinateShift(place);
    const Eigen::Vector3f near = (place - shift).cast<float>();
    const auto intensity = static_cast<float>(valueAt<std::uint16_t>(bytes.data(), 12));
    std::uint8_t* const to = &file.cloud.data[i * file.cloud.point_step];
    std::memcpy(to, near.data(), 3 * sizeof(float));
    std::memcpy(to + 3 * sizeof(float), &intensity, sizeof intensity);
    if (record.color > 0)
      colors.push_back(valueAt<Color16>(bytes.data(), record.color));
    to[layout.fields.back().offset] =
        static_cast<std::uint8_t>(bytes[record.classification]);
  }
  storeColors(colors, color_offset, file.cloud);
  setShift(shift, file);
  CoordinateCheck check(true);
  check.add(file);
  check.finish(file);
  return file;
}

} // namespace pcl::acmap
