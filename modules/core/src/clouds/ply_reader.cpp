#include "clouds/coordinate_shift.h"
#include "clouds/field_layout.h"
#include "clouds/field_names.h"
#include "clouds/ply_header.h"
#include "clouds/ply_list_rows.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"
#include "files/text_fields.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

std::vector<SourceField>
scalarFieldsOf(const PlyElement& element)
{
  std::vector<SourceField> fields;
  for (const PlyProperty& property : element.properties)
    if (!property.isList())
      fields.push_back({property.name, property.datatype, 1});
  renameFields(fields);
  return fields;
}

/** \brief Reads the rows of the elements in sequence. */
class PlyRows {
public:
  PlyRows(ByteSource& source, PlyHeader::Encoding encoding)
  : source_(source)
  , encoding_(encoding)
  , text_(encoding == PlyHeader::Encoding::ascii)
  , swap_(encoding == PlyHeader::Encoding::big_endian)
  {}

  void
  requireFit(const PlyElement& element)
  {
    if (text_)
      requireTextPointsFit(element.rows, element.properties.size(), source_);
    else
      requirePointsFit(element.rows, element.leastBytes(), source_);
  }

  void
  readVertices(const PlyElement& element,
               const CloudStatement& stated,
               LargeVector<std::uint8_t>* large,
               PointCloudFile& file);

  void
  skip(const PlyElement& element);

private:
  void
  readListedVertices(const PlyElement& element,
                     const FieldLayout& layout,
                     std::vector<double>& places,
                     std::uint8_t* points);

  void
  skipListed(const PlyElement& element);

  TextRow
  nextRow(const PlyElement& element, std::uint64_t row);

  void
  skipList(const PlyProperty& list);

  static void
  skipList(TextRow& row, const ByteSource& source);

  void
  skipText(const PlyElement& element);

  void
  readTextVertices(const PlyElement& element,
                   const FieldLayout& layout,
                   const CloudStatement& stated,
                   PointCloudFile& file);

  ByteSource& source_;
  PlyHeader::Encoding encoding_;
  bool text_;
  bool swap_;
};

TextRow
PlyRows::nextRow(const PlyElement& element, std::uint64_t row)
{
  std::string_view line;
  if (!source_.readFilledLine(line))
    source_.fail("header claims " + std::to_string(element.rows) + " rows of element " +
                 inQuotes(element.name) + ", the file has " + std::to_string(row));
  return TextRow(line, source_, true);
}

void
PlyRows::skipList(TextRow& row, const ByteSource& source)
{
  std::uint64_t length = 0;
  const std::string_view word = row.next();
  if (!parseCount(word, length))
    source.failAtLine(inQuotes(word) + " is no length of a list");
  for (std::uint64_t i = 0; i < length; ++i)
    row.next();
}

void
PlyRows::skipList(const PlyProperty& list)
{
  std::array<std::uint8_t, 8> bytes{};
  const std::size_t size = sizeOfType(list.length_datatype);
  source_.read(bytes.data(), size);
  if (swap_)
    swapValues(bytes.data(), size, size, 1);
  const double length = valueOfType(list.length_datatype, bytes.data());
  if (length < 0.0)
    source_.fail("list " + inQuotes(list.name) + " has a negative length");
  source_.skip(static_cast<std::uint64_t>(length) * sizeOfType(list.datatype));
}

void
PlyRows::readTextVertices(const PlyElement& element,
                          const FieldLayout& layout,
                          const CloudStatement& stated,
                          PointCloudFile& file)
{
  std::vector<double> places(static_cast<std::size_t>(3 * element.rows));
  std::uint8_t* const points = file.cloud.data.data();
  for (std::size_t i = 0; i < element.rows; ++i) {
    TextRow row = nextRow(element, i);
    std::size_t field = 0;
    for (const PlyProperty& property : element.properties)
      if (property.isList())
        skipList(row, source_);
      else
        storeField(row,
                   layout,
                   field++,
                   points + i * layout.point_step,
                   &places[3 * i],
                   source_);
    row.finish();
  }
  shiftPlaces(places, stated, !layout.narrows, file);
}

void
PlyRows::readVertices(const PlyElement& element,
                      const CloudStatement& stated,
                      LargeVector<std::uint8_t>* large,
                      PointCloudFile& file)
{
  FieldLayout layout = planLayout(scalarFieldsOf(element), source_);
  requireFit(element);
  const auto rows = static_cast<std::size_t>(element.rows);
  CoordinateCheck check(layout.narrows, stated.scale);
  if (!text_ && !element.hasList()) {
    layout.subtract(RecordBlocks::findShift(source_, layout, swap_, rows, stated));
    check.setShift(layout.shift);
    describeCloud(file.cloud, layout, rows, 1);
    RecordBlocks blocks(source_, layout, swap_);
    intoRows(large, file.cloud, [&](auto& data) {
      blocks.readAll(rows, data, check);
      packColors(layout, file.cloud, data.data());
    });
    noteShift(layout, stated, file);
    return check.finish(file);
  }
  shapeCloud(file.cloud, layout, rows, 1);
  std::uint8_t* const points = file.cloud.data.data();
  if (text_)
    readTextVertices(element, layout, stated, file);
  else {
    std::vector<double> places(3 * rows);
    readListedVertices(element, layout, places, points);
    shiftPlaces(places, stated, !layout.narrows, file);
  }
  packColors(layout, file.cloud, points);
  check.setShift(file.shift);
  check.add(file);
  check.finish(file);
}

void
PlyRows::readListedVertices(const PlyElement& element,
                            const FieldLayout& layout,
                            std::vector<double>& places,
                            std::uint8_t* points)
{
  const auto moves = layout.moves();
  std::vector<std::uint8_t> record(layout.source_step);
  for (std::size_t row = 0; row < element.rows; ++row) {
    std::size_t offset = 0;
    for (const PlyProperty& property : element.properties) {
      if (property.isList()) {
        skipList(property);
        continue;
      }
      const std::size_t size = sizeOfType(property.datatype);
      source_.read(&record[offset], size);
      offset += size;
    }
    if (swap_)
      swapRecords(layout, record.data(), 1);
    const Eigen::Vector3d place = layout.placeIn(record.data());
    std::copy_n(place.data(), 3, &places[3 * row]);
    moveRecords(moves, record.data(), 0, points + row * layout.point_step, 0, 1);
  }
}

void
PlyRows::skipText(const PlyElement& element)
{
  for (std::uint64_t i = 0; i < element.rows; ++i) {
    TextRow row = nextRow(element, i);
    for (const PlyProperty& property : element.properties)
      if (property.isList())
        skipList(row, source_);
      else
        row.next();
    row.finish();
  }
}

void
PlyRows::skip(const PlyElement& element)
{
  if (element.properties.empty())
    return;
  if (text_)
    return skipText(element);
  const std::uint64_t minimum = element.leastBytes();
  if (element.rows > source_.remaining() / minimum)
    source_.fail("header claims " + std::to_string(element.rows) + " rows of element " +
                 inQuotes(element.name) + ", " + std::to_string(source_.remaining()) +
                 " bytes follow");
  if (!element.hasList())
    return source_.skip(element.rows * minimum);
  skipListed(element);
}

void
PlyRows::skipListed(const PlyElement& element)
{
  const auto pass = [](const char*, std::uint32_t) { return true; };
  const std::optional<PlyListRow> layout = planListRow(element, encoding_);
  for (std::uint64_t row = 0; row < element.rows; ++row) {
    if (layout)
      row += forShortLists(source_, *layout, element.rows - row, pass);
    if (row == element.rows)
      return;
    for (const PlyProperty& property : element.properties) {
      if (property.isList())
        skipList(property);
      else
        source_.skip(sizeOfType(property.datatype));
    }
  }
}

/** Are the vertices those of a radiance field: ellipsoids, which are no measured points? */
bool
areSplats(const PlyElement& element)
{
  constexpr std::array<const char*, 4> names = {
      "opacity", "scale_0", "rot_0", "f_dc_0"};
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::any_of(
        element.properties.begin(),
        element.properties.end(),
        [&](const PlyProperty& property) { return property.name == name; });
  });
}

} // namespace

PointCloudFile
readPly(ByteSource& source,
        LargeVector<std::uint8_t>* points,
        const CloudStatement& stated)
{
  const PlyHeader header = readPlyHeader(source);
  PointCloudFile file;
  PlyRows rows(source, header.encoding);
  for (const PlyElement& element : header.elements)
    if (element.name == "vertex") {
      rows.readVertices(element, stated, points, file);
      if (areSplats(element))
        file.remarks.emplace_back(
            "holds Gaussian splats: their centres are taken as points, also where they "
            "float before surfaces; their sizes, opacities and colours are not read");
    }
    else
      rows.skip(element);
  return file;
}

} // namespace pcl::acmap
