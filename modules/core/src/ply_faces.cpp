#include "mesh_codecs.h"

#include "byte_source.h"
#include "ply_header.h"
#include "record_moves.h"
#include "text_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief Reads the values of an element one after another, in any encoding. */
class PlyValues {
public:
  PlyValues(ByteSource& source, PlyHeader::Encoding encoding)
  : source_(source)
  , text_(encoding == PlyHeader::Encoding::ascii)
  , swap_(encoding == PlyHeader::Encoding::big_endian)
  {}

  void
  beginRow(const PlyElement& element)
  {
    std::string_view line;
    if (!text_)
      return;
    if (!source_.readFilledLine(line))
      source_.fail("ends within element " + inQuotes(element.name));
    row_ = Words(line);
  }

  double
  next(std::uint8_t datatype)
  {
    if (text_)
      return nextOfText();
    std::array<std::uint8_t, 8> bytes{};
    const std::size_t size = sizeOfType(datatype);
    source_.read(bytes.data(), size);
    if (swap_)
      swapValues(bytes.data(), size, size, 1);
    return valueOfType(datatype, bytes.data());
  }

  void
  nextList(const PlyProperty& list, std::vector<double>& values)
  {
    const double length = next(list.length_datatype);
    const auto maximum = static_cast<double>(source_.remaining());
    if (!(length >= 0) || (!text_ && length > maximum) ||
        (text_ && length > static_cast<double>(ByteSource::maximum_line)))
      source_.fail("list " + inQuotes(list.name) + " has an impossible length");
    values.resize(static_cast<std::size_t>(length));
    for (double& value : values)
      value = next(list.datatype);
  }

  void
  skip(const PlyElement& element)
  {
    if (element.properties.empty())
      return;
    if (!text_ && !element.hasList())
      return skipRecords(element);
    std::vector<double> values;
    for (std::uint64_t row = 0; row < element.rows; ++row) {
      beginRow(element);
      for (std::size_t i = 0; !text_ && i < element.properties.size(); ++i)
        skip(element.properties[i], values);
    }
  }

  void
  skip(const PlyProperty& property, std::vector<double>& values)
  {
    if (property.isList())
      nextList(property, values);
    else
      next(property.datatype);
  }

private:
  double
  nextOfText()
  {
    std::string_view word;
    double value = 0;
    if (!row_.next(word) || !parseNumber(word, value))
      source_.failAtLine(inQuotes(word) + " is not a number");
    return value;
  }

  void
  skipRecords(const PlyElement& element)
  {
    const std::uint64_t bytes = element.leastBytes();
    if (bytes > 0 && element.rows > source_.remaining() / bytes)
      source_.fail("ends within element " + inQuotes(element.name));
    source_.skip(element.rows * bytes);
  }

  ByteSource& source_;
  bool text_;
  bool swap_;
  Words row_{std::string_view()};
};

bool
holdsCorners(const PlyProperty& property)
{
  return property.isList() &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool
holdsDepth(const PlyProperty& property)
{
  return !property.isList() && property.name == "wall_depth";
}

std::uint8_t
depthOf(double value, std::uint64_t face, const ByteSource& source)
{
  if (!(value >= 0 && value <= TriangleMesh::no_wall && value == std::floor(value)))
    source.fail("face " + std::to_string(face) +
                " has a wall_depth that is none of 0 to 255");
  return static_cast<std::uint8_t>(value);
}

/** \brief Adds a polygon as a triangle fan. */
void
addPolygon(const std::vector<double>& corners,
           double vertices,
           TriangleMesh& mesh,
           const ByteSource& source)
{
  for (const double corner : corners)
    if (!(corner >= 0 && corner < vertices && corner == std::floor(corner)))
      source.fail("face " + std::to_string(mesh.triangles.size()) +
                  " has a corner outside of the vertices");
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.push_back({static_cast<std::int32_t>(corners[0]),
                              static_cast<std::int32_t>(corners[i - 1]),
                              static_cast<std::int32_t>(corners[i])});
}

void
readFaces(PlyValues& values,
          const PlyElement& element,
          double vertices,
          TriangleMesh& mesh,
          const ByteSource& source)
{
  if (std::none_of(element.properties.begin(), element.properties.end(), holdsCorners))
    return values.skip(element);
  std::vector<double> corners;
  std::vector<double> others;
  for (std::uint64_t row = 0; row < element.rows; ++row) {
    values.beginRow(element);
    std::optional<std::uint8_t> depth;
    for (const PlyProperty& property : element.properties)
      if (holdsDepth(property))
        depth = depthOf(values.next(property.datatype), row, source);
      else
        values.skip(property, holdsCorners(property) ? corners : others);
    addPolygon(corners, vertices, mesh, source);
    if (depth)
      mesh.wall_depth.resize(mesh.triangles.size(), *depth);
  }
}

} // namespace

TriangleMesh
readPlyFaces(ByteSource& source)
{
  const PlyHeader header = readPlyHeader(source);
  const auto vertex = std::find_if(header.elements.begin(),
                                   header.elements.end(),
                                   [](const auto& e) { return e.name == "vertex"; });
  const auto vertices = static_cast<double>(
      std::min<std::uint64_t>(vertex->rows, std::numeric_limits<std::int32_t>::max()));
  PlyValues values(source, header.encoding);
  TriangleMesh mesh;
  for (const PlyElement& element : header.elements) {
    if (element.name == "face")
      readFaces(values, element, vertices, mesh, source);
    else
      values.skip(element);
  }
  return mesh;
}

} // namespace pcl::acmap
