#include "byte_source.h"
#include "field_layout.h"
#include "ply_header.h"
#include "point_cloud_readers.h"
#include "text_fields.h"

#include <pcl/PCLPointField.h>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

std::string
pclNameOf(const std::string& name)
{
  static constexpr std::pair<const char*, const char*> names[] = {
      {"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}};
  for (const auto& [ply, pcl] : names)
    if (name == ply)
      return pcl;
  return name;
}

std::vector<SourceField>
scalarFieldsOf(const PlyElement& element)
{
  std::vector<SourceField> fields;
  for (const PlyProperty& property : element.properties)
    if (!property.isList())
      fields.push_back({pclNameOf(property.name), property.datatype, 1});
  return fields;
}

/** \brief Reads the rows of the elements in sequence. */
class PlyRows {
public:
  PlyRows(ByteSource& source, PlyHeader::Encoding encoding)
  : source_(source)
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
               const FieldLayout& layout,
               std::uint8_t* points);

  void
  skip(const PlyElement& element);

private:
  Words
  nextRow(const PlyElement& element, std::uint64_t row);

  void
  skipList(const PlyProperty& list);

  static void
  skipList(Words& row, const ByteSource& source);

  void
  readTextVertex(Words row,
                 const PlyElement& element,
                 const FieldLayout& layout,
                 std::uint8_t* point);

  ByteSource& source_;
  bool text_;
  bool swap_;
};

Words
PlyRows::nextRow(const PlyElement& element, std::uint64_t row)
{
  std::string_view line;
  if (!source_.readFilledLine(line))
    source_.fail("header claims " + std::to_string(element.rows) + " rows of element " +
                 inQuotes(element.name) + ", the file has " + std::to_string(row));
  return Words(line);
}

void
PlyRows::skipList(Words& row, const ByteSource& source)
{
  std::uint64_t length = 0;
  const std::string_view word = nextWord(row, source);
  if (!parseCount(word, length))
    source.failAtLine(inQuotes(word) + " is no length of a list");
  for (std::uint64_t i = 0; i < length; ++i)
    nextWord(row, source);
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
PlyRows::readTextVertex(Words row,
                        const PlyElement& element,
                        const FieldLayout& layout,
                        std::uint8_t* point)
{
  std::size_t field = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.isList())
      skipList(row, source_);
    else
      storeField(row, layout, field++, point, source_);
  }
}

void
PlyRows::readVertices(const PlyElement& element,
                      const FieldLayout& layout,
                      std::uint8_t* points)
{
  const auto rows = static_cast<std::size_t>(element.rows);
  if (text_) {
    for (std::size_t row = 0; row < rows; ++row)
      readTextVertex(
          nextRow(element, row), element, layout, points + row * layout.point_step);
    return;
  }
  if (!element.hasList()) {
    readRecords(source_, layout, swap_, rows, points);
    return;
  }
  const auto moves = layout.moves();
  std::vector<std::uint8_t> record(layout.source_step);
  for (std::size_t row = 0; row < rows; ++row) {
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
    moveRecords(moves, record.data(), 0, points + row * layout.point_step, 0, 1);
  }
}

void
PlyRows::skip(const PlyElement& element)
{
  if (element.properties.empty())
    return;
  if (text_) {
    for (std::uint64_t row = 0; row < element.rows; ++row)
      nextRow(element, row);
    return;
  }
  const std::uint64_t minimum = element.leastBytes();
  if (element.rows > source_.remaining() / minimum)
    source_.fail("header claims " + std::to_string(element.rows) + " rows of element " +
                 inQuotes(element.name) + ", " + std::to_string(source_.remaining()) +
                 " bytes follow");
  if (!element.hasList())
    return source_.skip(element.rows * minimum);
  for (std::uint64_t row = 0; row < element.rows; ++row)
    for (const PlyProperty& property : element.properties) {
      if (property.isList())
        skipList(property);
      else
        source_.skip(sizeOfType(property.datatype));
    }
}

} // namespace

PointCloudFile
readPly(ByteSource& source)
{
  const PlyHeader header = readPlyHeader(source);
  PointCloudFile file;
  PlyRows rows(source, header.encoding);
  bool narrows = false;
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") {
      rows.skip(element);
      continue;
    }
    const FieldLayout layout = planLayout(scalarFieldsOf(element), source);
    rows.requireFit(element);
    shapeCloud(file.cloud, layout, element.rows, 1);
    rows.readVertices(element, layout, file.cloud.data.data());
    narrows = layout.narrows;
  }
  inspectCoordinates(file, narrows);
  return file;
}

} // namespace pcl::acmap
