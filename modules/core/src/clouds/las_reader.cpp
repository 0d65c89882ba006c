#include "clouds/coordinate_shift.h"
#include "clouds/las_records.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"

#include <pcl/core/impl/unit_text.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief What a point data record format of LAS 1.0 to 1.5 has, offsets in bytes. */
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
  std::uint64_t first_point = 0, points = 0;
  std::uint64_t points_end = 0; ///< no point is behind it
  std::size_t format = 0, record_bytes = 0;
  LasRecords records, extended_records;
  Eigen::Vector3d scale, offset;
  Eigen::Vector2d farthest; ///< bounds of x and y, absolute
};

/** \brief Takes format, size and number of the points from the bytes of a header.
 * \throws InputFileException for points that are packed or unknown */
void
readPointFormat(const char* bytes, bool is_1_4, LasHeader& header, ByteSource& source)
{
  const auto format = static_cast<std::uint8_t>(bytes[104]);
  constexpr std::uint8_t packed = 0xC0; // bits that LASzip sets
  if ((format & packed) != 0)
    source.fail(packedAdvice(source.name()));
  if (format >= las_records.size())
    source.fail("has points of format " + std::to_string(format) +
                ", 0 to 10 are known");
  header.format = format;
  header.record_bytes = valueAt<std::uint16_t>(bytes, 105);
  if (header.record_bytes < las_records[header.format].bytes)
    source.fail("claims points of " + std::to_string(header.record_bytes) +
                " bytes, those of format " + std::to_string(format) + " have " +
                std::to_string(las_records[header.format].bytes));
  header.points = valueAt<std::uint32_t>(bytes, 107);
  if (const auto count = valueAt<std::uint64_t>(bytes, 247); is_1_4 && count > 0)
    header.points = count;
}

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
  if (major != 1 || minor < 0 || minor > 5)
    source.fail("is LAS " + std::to_string(major) + "." + std::to_string(minor) +
                ", 1.0 to 1.5 are read");
  const bool is_1_4 = minor >= 4 && valueAt<std::uint16_t>(bytes.data(), 94) >= of_1_4;
  if (is_1_4) {
    if (source.remaining() < of_1_4 - shortest)
      source.fail("is shorter than its header");
    source.read(bytes.data() + shortest, of_1_4 - shortest);
  }
  LasHeader header;
  header.first_point = valueAt<std::uint32_t>(bytes.data(), 96);
  if (header.first_point < (is_1_4 ? of_1_4 : shortest))
    source.fail("claims points within its header");
  if (header.first_point > source.size())
    source.fail("ends before its points");
  header.records = {
      valueAt<std::uint16_t>(bytes.data(), 94), header.first_point, false};
  header.points_end = source.size();
  if (const auto begin = valueAt<std::uint64_t>(bytes.data(), 235);
      is_1_4 && begin >= header.first_point && begin < source.size()) {
    header.extended_records = {begin, source.size(), true};
    header.points_end = begin;
  }
  readPointFormat(bytes.data(), is_1_4, header, source);
  for (int axis = 0; axis < 3; ++axis) {
    header.scale[axis] = valueAt<double>(bytes.data(), 131 + 8 * axis);
    header.offset[axis] = valueAt<double>(bytes.data(), 155 + 8 * axis);
  }
  if (!header.scale.allFinite() || !header.offset.allFinite() ||
      (header.scale.array() == 0).any())
    source.fail("has a scale or an offset that is no number");
  for (int axis = 0; axis < 2; ++axis)
    header.farthest[axis] =
        std::max(std::abs(valueAt<double>(bytes.data(), 179 + 16 * axis)),
                 std::abs(valueAt<double>(bytes.data(), 187 + 16 * axis)));
  return header;
}

Eigen::Vector3d
lasPlace(const char* record, const LasHeader& header)
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

/** \brief Packs the colours of points, of 16 bits, or of 8 where none of them needs more. */
class LasColors {
public:
  /** \param[in] offset of the colour in a point
   * \param[in] step bytes of a point */
  LasColors(std::size_t offset, std::size_t step)
  : offset_(offset)
  , step_(step)
  {}

  /** \brief Stores the colour of the next point.
   * \param[in,out] points all so far, and this one */
  void
  store(const Color16& color, std::uint8_t* points)
  {
    if (shift_ == 0 && *std::max_element(color.begin(), color.end()) > 255)
      widen(points);
    put(color, points + stored_++ * step_);
  }

private:
  void
  put(const Color16& color, std::uint8_t* point) const
  {
    for (std::size_t c = 0; c < 3; ++c)
      point[offset_ + 2 - c] = static_cast<std::uint8_t>(color[c] >> shift_);
  }

  /** The points so far have colours below 256, which are black among those of 16 bits. */
  void
  widen(std::uint8_t* points)
  {
    shift_ = 8;
    for (std::size_t i = 0; i < stored_; ++i)
      put({}, points + i * step_);
  }

  std::size_t offset_, step_, stored_ = 0;
  int shift_ = 0;
};

/** \brief Makes points of records. */
class LasPoints {
public:
  /** \param[in] shift to be subtracted from coordinates */
  LasPoints(const LasHeader& header,
            const FieldLayout& layout,
            const Eigen::Vector3d& shift)
  : header_(header)
  , record_(las_records[header.format])
  , step_(layout.point_step)
  , classification_(layout.fields.back().offset)
  , colors_(4 * sizeof(float), layout.point_step)
  , shift_(shift)
  {}

  /** \brief Stores the point of the next record.
   * \param[in,out] points all so far, and this one */
  void
  store(const char* record, std::uint8_t* points)
  {
    std::uint8_t* const to = points + stored_++ * step_;
    const Eigen::Vector3f near = (lasPlace(record, header_) - shift_).cast<float>();
    const auto intensity = static_cast<float>(valueAt<std::uint16_t>(record, 12));
    std::memcpy(to, near.data(), 3 * sizeof(float));
    std::memcpy(to + 3 * sizeof(float), &intensity, sizeof intensity);
    to[classification_] = static_cast<std::uint8_t>(record[record_.classification]);
    if (record_.color > 0)
      colors_.store(valueAt<Color16>(record, record_.color), points);
  }

private:
  const LasHeader& header_;
  const LasRecord& record_;
  std::size_t step_;           ///< bytes of a point
  std::size_t classification_; ///< offset in a point
  std::size_t stored_ = 0;
  LasColors colors_;
  Eigen::Vector3d shift_;
};

/** \brief Finds the shift of the records that follow, from some of them. */
Eigen::Vector3d
shiftOfRecords(ByteSource& source,
               const LasHeader& header,
               const CloudStatement& stated)
{
  constexpr std::uint64_t places = 64, together = CoordinateSample::enough / places;
  const std::uint64_t begin = source.size() - source.remaining();
  CoordinateSample sample;
  std::vector<char> records;
  for (std::uint64_t at = 0; at < header.points;
       at += std::max(header.points / places, together)) {
    const auto now = static_cast<std::size_t>(std::min(together, header.points - at));
    records.resize(now * header.record_bytes);
    source.moveTo(begin + at * header.record_bytes);
    source.read(records.data(), records.size());
    for (std::size_t i = 0; i < now; ++i)
      sample.add(lasPlace(&records[i * header.record_bytes], header));
  }
  source.moveTo(begin);
  return sample.shift(stated);
}

/** \brief Reads all records, one block after the other.
 * \param[in] shift to be subtracted from coordinates
 * \param[out] data vector of bytes */
template <typename Bytes>
void
readRecords(ByteSource& source,
            const LasHeader& header,
            const FieldLayout& layout,
            const Eigen::Vector3d& shift,
            Bytes& data,
            CoordinateCheck& check)
{
  LasPoints points(header, layout, shift);
  std::vector<char> records;
  appendBlocks(static_cast<std::size_t>(header.points),
               layout.point_step,
               ByteSource::maximum_line / header.record_bytes + 1,
               data,
               [&](std::size_t count, std::uint8_t* block) {
                 records.resize(count * header.record_bytes);
                 source.read(records.data(), records.size());
                 for (std::size_t i = 0; i < count; ++i)
                   points.store(&records[i * header.record_bytes], data.data());
                 check.add(block, layout.point_step, count);
               });
}

/** \brief Counts the points of a file whose header was written before them. */
void
countStreamedPoints(LasHeader& header, PointCloudFile& file)
{
  if (header.points > 0)
    return;
  const std::uint64_t bytes = header.points_end - header.first_point;
  header.points = bytes / header.record_bytes;
  if (header.points > 0)
    file.remarks.push_back(
        "its header claims no points, " + std::to_string(header.points) +
        " follow: it was probably not closed" +
        (bytes % header.record_bytes > 0 ? ", and the last one is incomplete" : ""));
}

/** \brief Makes metres of the units that the file states, unless the caller states one. Heights
 * without a unit have that of x and y.
 * \throws InputFileException for degrees */
void
useUnitsOfFile(LasHeader& header,
               const CloudStatement& stated,
               ByteSource& source,
               PointCloudFile& file)
{
  if (stated.is_scale_stated)
    return;
  CoordinateUnits units = unitsOfRecords(header.records, source);
  if (!units.across && !units.are_degrees && !units.system)
    units = unitsOfRecords(header.extended_records, source);
  if (units.system)
    file.remarks.push_back(
        "names its reference system, EPSG:" + std::to_string(*units.system) +
        ", but no unit: metres were taken; --scale states another");
  if (units.are_degrees && !(header.farthest.x() > 360) && !(header.farthest.y() > 90))
    source.fail("has degrees of latitude and longitude: project them to metres first");
  const auto isLength = [](double metres) { return metres > 1e-4 && metres < 1e4; };
  if (!units.across || !isLength(*units.across))
    return;
  const double across = *units.across;
  const double up = units.up && isLength(*units.up) ? *units.up : across;
  const Eigen::Vector3d metres(across, across, up);
  file.stated_scale = across;
  header.scale = header.scale.cwiseProduct(metres);
  header.offset = header.offset.cwiseProduct(metres);
  if (across != 1 || up != 1)
    file.remarks.push_back(
        "it states its units: " + unitText(across) + " m" +
        (up == across ? "" : ", of its heights " + unitText(up) + " m") +
        " were taken for 1; --scale states another");
}

} // namespace

PointCloudFile
readLas(ByteSource& source,
        LargeVector<std::uint8_t>* rows,
        const CloudStatement& stated)
{
  LasHeader header = readLasHeader(source);
  PointCloudFile file;
  countStreamedPoints(header, file);
  useUnitsOfFile(header, stated, source, file);
  source.moveTo(header.first_point);
  requirePointsFit(header.points, header.record_bytes, source);
  const bool has_color = las_records[header.format].color > 0;
  const FieldLayout layout = planLayout(lasFields(has_color), source);
  describeCloud(file.cloud, layout, header.points, 1);
  CoordinateCheck check(true, stated.scale);
  file.up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3d shift = shiftOfRecords(source, header, stated);
  setShift(shift, stated, file);
  check.setShift(shift);
  intoRows(rows, file.cloud, [&](auto& data) {
    readRecords(source, header, layout, shift, data, check);
  });
  check.finish(file);
  return file;
}

} // namespace pcl::acmap
