#include "clouds/mesh_codecs.h"

#include "clouds/ply_header.h"
#include "clouds/ply_list_rows.h"
#include "files/byte_source.h"
#include "files/record_moves.h"
#include "files/text_fields.h"
#include <pcl/core/impl/large_memory.h>

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
    row_.emplace(line, source_, true);
  }

  void
  endRow()
  {
    if (text_)
      row_->finish();
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
      for (const PlyProperty& property : element.properties)
        skip(property, values);
      endRow();
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
    const std::string_view word = row_->next();
    double value = 0;
    if (!parseNumber(word, value))
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
  std::optional<TextRow> row_;
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

/** \brief Layout of faces that are read where they are in the buffer: one list, of
 * integers, and at most one `wall_depth`, of a byte. */
struct FaceRow {
  PlyListRow layout;
  std::uint32_t corner_limit = 0; // corners that are not less are left to PlyValues
  bool has_depth = false;
  bool depth_precedes = false; // the list
  std::size_t depth = 0;       // position in the bytes before or after the list

  std::uint8_t
  depthOf(const char* row, std::uint32_t length) const
  {
    const char* const at =
        depth_precedes ? row : row + layout.bytes(length) - layout.after;
    return static_cast<std::uint8_t>(at[depth]);
  }
};

/** \brief Least number that is no corner: also excludes negative ones of a type. */
std::uint32_t
cornerLimit(std::uint8_t datatype, double vertices)
{
  switch (datatype) {
  case PCLPointField::INT8:
    return static_cast<std::uint32_t>(std::min(vertices, 128.0));
  case PCLPointField::INT16:
    return static_cast<std::uint32_t>(std::min(vertices, 32768.0));
  default:
    return static_cast<std::uint32_t>(vertices); // at most 2^31 - 1
  }
}

std::optional<FaceRow>
planFaceRow(const PlyElement& element, PlyHeader::Encoding encoding, double vertices)
{
  const std::optional<PlyListRow> layout = planListRow(element, encoding);
  if (!layout || !holdsCorners(*layout->list) ||
      layout->list->datatype == PCLPointField::FLOAT32 ||
      layout->list->datatype == PCLPointField::FLOAT64)
    return std::nullopt;
  FaceRow row;
  row.layout = *layout;
  row.corner_limit = cornerLimit(layout->list->datatype, vertices);
  std::size_t position = 0;
  row.depth_precedes = true;
  bool precedes = true;
  for (const PlyProperty& property : element.properties) {
    if (property.isList()) {
      precedes = false;
      position = 0;
      continue;
    }
    if (holdsDepth(property)) {
      if (row.has_depth || property.datatype != PCLPointField::UINT8)
        return std::nullopt;
      row.has_depth = true;
      row.depth_precedes = precedes;
      row.depth = position;
    }
    position += sizeOfType(property.datatype);
  }
  return row;
}

/** \brief Adds the fan of a polygon if all its corners are less than the limit. */
template <typename Corner, bool Swap>
bool
addFan(const char* corners,
       std::uint32_t length,
       std::uint32_t limit,
       TriangleMesh::Triangles& triangles)
{
  const auto corner = [&](std::uint32_t i) -> std::uint32_t {
    return loadUnsigned<Corner>(corners + i * sizeof(Corner), Swap);
  };
  // Written in place: a triangle made elsewhere is stored in three parts and loaded in
  // two, which waits for the stores.
  const auto add = [&](std::uint32_t b, std::uint32_t c) {
    TriangleMesh::Triangle& triangle = triangles.emplace_back();
    triangle[0] = static_cast<std::int32_t>(corner(0));
    triangle[1] = static_cast<std::int32_t>(b);
    triangle[2] = static_cast<std::int32_t>(c);
  };
  if (length == 3) { // nearly always, and without loops
    const std::uint32_t b = corner(1);
    const std::uint32_t c = corner(2);
    if (std::max({corner(0), b, c}) >= limit)
      return false;
    add(b, c);
    return true;
  }
  for (std::uint32_t i = 0; i < length; ++i)
    if (corner(i) >= limit)
      return false;
  for (std::uint32_t i = 2; i < length; ++i)
    add(corner(i - 1), corner(i));
  return true;
}

/** \brief Adds faces until one is not of the usual form.
 * \return their number */
template <typename Corner, bool Swap>
std::uint64_t
addUsualFaces(ByteSource& source,
              const FaceRow& face,
              std::uint64_t rows,
              TriangleMesh& mesh)
{
  const auto add = [face, &mesh](const char* row, std::uint32_t length) {
    if (!addFan<Corner, Swap>(
            row + face.layout.valuesBegin(), length, face.corner_limit, mesh.triangles))
      return false;
    if (face.has_depth)
      mesh.wall_depth.resize(mesh.triangles.size(), face.depthOf(row, length));
    return true;
  };
  return forShortLists(source, face.layout, rows, add);
}

template <typename Corner>
std::uint64_t
addUsualFaces(ByteSource& source,
              const FaceRow& face,
              std::uint64_t rows,
              TriangleMesh& mesh)
{
  return face.layout.swap ? addUsualFaces<Corner, true>(source, face, rows, mesh)
                          : addUsualFaces<Corner, false>(source, face, rows, mesh);
}

std::uint64_t
addUsualFaces(ByteSource& source,
              const FaceRow& face,
              std::uint64_t rows,
              TriangleMesh& mesh)
{
  switch (face.layout.value_bytes) {
  case 1:
    return addUsualFaces<std::uint8_t>(source, face, rows, mesh);
  case 2:
    return addUsualFaces<std::uint16_t>(source, face, rows, mesh);
  default:
    return addUsualFaces<std::uint32_t>(source, face, rows, mesh);
  }
}

/** \brief Reserves memory for as many triangles as rows and remaining bytes allow. */
void
reserveTriangles(const FaceRow& face,
                 std::uint64_t rows,
                 const ByteSource& source,
                 TriangleMesh& mesh)
{
  const auto most = static_cast<std::size_t>(
      std::min<std::uint64_t>(rows, source.remaining() / face.layout.bytes(3)));
  reserveLarge(mesh.triangles, most);
  if (face.has_depth)
    reserveLarge(mesh.wall_depth, most);
}

void
readFaces(PlyValues& values,
          const PlyElement& element,
          const std::optional<FaceRow>& usual,
          double vertices,
          TriangleMesh& mesh,
          ByteSource& source)
{
  if (std::none_of(element.properties.begin(), element.properties.end(), holdsCorners))
    return values.skip(element);
  if (usual)
    reserveTriangles(*usual, element.rows, source, mesh);
  std::vector<double> corners;
  std::vector<double> others;
  for (std::uint64_t row = 0; row < element.rows; ++row) {
    if (usual)
      row += addUsualFaces(source, *usual, element.rows - row, mesh);
    if (row == element.rows)
      return;
    values.beginRow(element);
    std::optional<std::uint8_t> depth;
    for (const PlyProperty& property : element.properties)
      if (holdsDepth(property))
        depth = depthOf(values.next(property.datatype), row, source);
      else
        values.skip(property, holdsCorners(property) ? corners : others);
    values.endRow();
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
      readFaces(values,
                element,
                planFaceRow(element, header.encoding, vertices),
                vertices,
                mesh,
                source);
    else
      values.skip(element);
  }
  return mesh;
}

} // namespace pcl::acmap
