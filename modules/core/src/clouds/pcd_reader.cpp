#include "clouds/coordinate_shift.h"
#include "clouds/field_layout.h"
#include "clouds/field_names.h"
#include "clouds/pcd_header.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"
#include "files/text_fields.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

namespace pcl::acmap {

namespace {

void
readRows(ByteSource& source,
         const FieldLayout& layout,
         std::vector<double>& places,
         PointCloudFile& file)
{
  PCLPointCloud2& cloud = file.cloud;
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  std::string_view line;
  bool longer = false;
  for (std::size_t i = 0; i < points; ++i) {
    if (!source.readFilledLine(line))
      source.fail("header claims " + std::to_string(points) + " points, the file has " +
                  std::to_string(i));
    TextRow row(line, source, false);
    for (std::size_t field = 0; field < layout.source.size(); ++field)
      storeField(row,
                 layout,
                 field,
                 &cloud.data[i * layout.point_step],
                 &places[3 * i],
                 source);
    longer = row.finish() || longer;
  }
  if (longer)
    file.remarks.emplace_back(
        "some rows have more values than the header names; these were left out");
}

void
readAscii(ByteSource& source,
          const PcdHeader& header,
          const FieldLayout& layout,
          const CloudStatement& stated,
          PointCloudFile& file)
{
  std::uint64_t values = 0;
  for (const SourceField& field : layout.source)
    values += static_cast<std::uint64_t>(std::max<std::int64_t>(field.count, 0));
  requireTextPointsFit(header.points, values, source);
  shapeCloud(file.cloud, layout, header.width, header.height);
  std::vector<double> places(static_cast<std::size_t>(3 * header.points));
  readRows(source, layout, places, file);
  shiftPlaces(places, stated, !layout.narrows, file);
}

void
readBinary(ByteSource& source,
           const PcdHeader& header,
           FieldLayout& layout,
           const CloudStatement& stated,
           PointCloudFile& file,
           LargeVector<std::uint8_t>* rows,
           CoordinateCheck& check)
{
  requirePointsFit(header.points, layout.source_step, source);
  layout.subtract(
      RecordBlocks::findShift(source, layout, false, header.points, stated));
  check.setShift(layout.shift);
  describeCloud(file.cloud, layout, header.width, header.height);
  RecordBlocks blocks(source, layout, false);
  intoRows(rows, file.cloud, [&](auto& data) {
    blocks.readAll(static_cast<std::size_t>(header.points), data, check);
  });
}

std::unique_ptr<std::uint8_t[]>
unpack(ByteSource& source, std::uint32_t packed_size, std::uint32_t size)
{
  // LZF expands three bytes to at most 264 bytes.
  constexpr std::uint64_t best_ratio = 88;
  if (packed_size > source.remaining())
    source.fail("header claims a block of " + std::to_string(packed_size) + " bytes, " +
                std::to_string(source.remaining()) + " follow");
  if (size > best_ratio * packed_size)
    source.fail("header claims that " + std::to_string(packed_size) +
                " bytes unpack to " + std::to_string(size));
  // Not initialised, because both are filled completely.
  const std::unique_ptr<std::uint8_t[]> packed(new std::uint8_t[packed_size]);
  std::unique_ptr<std::uint8_t[]> block(new std::uint8_t[size]);
  source.read(packed.get(), packed_size);
  if (lzf_decompress(packed.get(), packed_size, block.get(), size) != size)
    source.fail("compressed block is damaged");
  return block;
}

/** The shift of points whose values are one field after the other. */
Eigen::Vector3d
shiftOfColumns(const FieldLayout& layout,
               const std::uint8_t* block,
               std::size_t points,
               const CloudStatement& stated)
{
  std::array<const std::uint8_t*, 3> columns{};
  for (std::size_t i = 0; i < layout.source.size(); ++i) {
    if (layout.source[i].isPadding())
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (layout.coordinates[axis] == i)
        columns[axis] = block;
    block += layout.source[i].bytes() * points;
  }
  CoordinateSample sample;
  for (std::size_t i = 0; i < points; i += points / CoordinateSample::enough + 1) {
    Eigen::Vector3d place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const SourceField& field = layout.source[layout.coordinates[axis]];
      place[static_cast<Eigen::Index>(axis)] =
          valueOfType(field.datatype, columns[axis] + i * field.bytes());
    }
    sample.add(place);
  }
  return sample.shift(stated);
}

// The block contains all values of the first field, then all of the second, and so on;
// padding is omitted.
void
readCompressed(ByteSource& source,
               const PcdHeader& header,
               FieldLayout& layout,
               const CloudStatement& stated,
               PointCloudFile& file)
{
  std::uint32_t packed_size = 0;
  std::uint32_t size = 0;
  if (header.points > 0) {
    source.read(&packed_size, sizeof(packed_size));
    source.read(&size, sizeof(size));
  }
  std::uint64_t step = 0;
  for (const SourceField& field : layout.source)
    step += field.isPadding() ? 0 : field.bytes();
  if (size / step != header.points || size % step != 0)
    source.fail("header claims " + std::to_string(header.points) + " points of " +
                std::to_string(step) + " bytes, the compressed block " +
                std::to_string(size) + " bytes");
  if (header.points == 0)
    return shapeCloud(file.cloud, layout, header.width, header.height);
  const auto block = unpack(source, packed_size, size);
  shapeCloud(file.cloud, layout, header.width, header.height);
  const auto points = static_cast<std::size_t>(header.points);
  layout.subtract(shiftOfColumns(layout, block.get(), points, stated));
  const std::uint8_t* column = block.get();
  for (std::size_t i = 0; i < layout.source.size(); ++i) {
    if (layout.source[i].isPadding())
      continue;
    const std::size_t bytes = layout.source[i].bytes();
    moveRecords({layout.moveOf(i)},
                column,
                bytes,
                file.cloud.data.data(),
                layout.point_step,
                points);
    column += bytes * points;
  }
}

// PCL's writer fills the last page with zeros.
bool
onlyZerosFollow(ByteSource& source)
{
  std::array<char, 65536> rest;
  const auto bytes = static_cast<std::size_t>(source.remaining());
  if (bytes > rest.size())
    return false;
  source.read(rest.data(), bytes);
  return std::all_of(rest.begin(), rest.begin() + bytes, [](char c) { return c == 0; });
}

void
remarkRest(ByteSource& source, bool text, PointCloudFile& file)
{
  std::string_view line;
  if (text ? source.readFilledLine(line) : !onlyZerosFollow(source))
    file.remarks.emplace_back(
        "the file goes on after the points that the header claims; the rest was left "
        "out");
}

} // namespace

PointCloudFile
readPcd(ByteSource& source,
        LargeVector<std::uint8_t>* rows,
        const CloudStatement& stated)
{
  PcdHeader header = readPcdHeader(source);
  renameFields(header.fields);
  FieldLayout layout = planLayout(std::move(header.fields), source);
  PointCloudFile file;
  file.sensor_orientation = header.orientation;
  file.remarks = std::move(header.remarks);
  CoordinateCheck check(layout.narrows, stated.scale);
  switch (header.encoding) {
  case PcdHeader::Encoding::ascii:
    readAscii(source, header, layout, stated, file);
    check.setShift(file.shift);
    check.add(file);
    break;
  case PcdHeader::Encoding::binary:
    readBinary(source, header, layout, stated, file, rows, check);
    break;
  case PcdHeader::Encoding::binary_compressed:
    readCompressed(source, header, layout, stated, file);
    check.setShift(layout.shift);
    check.add(file);
    break;
  }
  noteShift(layout, stated, file);
  if (!header.origin.isZero(0)) // else it is what PCL writes if nothing is known
    file.sensor_origin = (header.origin - file.shift).cast<float>();
  intoRows(file.cloud.data.empty() ? rows : nullptr, file.cloud, [&](auto& data) {
    packColors(layout, file.cloud, data.data());
  });
  remarkRest(source, header.encoding == PcdHeader::Encoding::ascii, file);
  check.finish(file);
  return file;
}

} // namespace pcl::acmap
