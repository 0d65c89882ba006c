#include "clouds/mesh_codecs.h"
#include "files/record_moves.h"
#include "files/record_writer.h"

#include <cstring>
#include <string>

namespace pcl::acmap {

namespace {

const char*
vtkTypeOf(std::uint8_t datatype)
{
  switch (datatype) {
  case PCLPointField::INT8:
    return "char";
  case PCLPointField::UINT8:
    return "unsigned_char";
  case PCLPointField::INT16:
    return "short";
  case PCLPointField::UINT16:
    return "unsigned_short";
  case PCLPointField::INT32:
    return "int";
  case PCLPointField::UINT32:
    return "unsigned_int";
  case PCLPointField::FLOAT32:
    return "float";
  default:
    return "double";
  }
}

/** \brief Legacy VTK: lines of text and blocks of big-endian numbers between them. */
class VtkWriter {
public:
  VtkWriter(OutputFile& file, const CloudRows& cloud)
  : file_(file)
  , cloud_(cloud)
  , points_(cloud.size())
  {}

  std::size_t
  points() const
  {
    return points_;
  }

  void
  text(const std::string& line)
  {
    file_.write(line.data(), line.size());
  }

  /** \brief Writes the values of each point at some offsets, all of the same size. */
  void
  pointValues(const std::vector<std::size_t>& offsets, std::size_t size);

  void
  polygons(const TriangleMesh& mesh);

private:
  OutputFile& file_;
  const CloudRows& cloud_;
  std::size_t points_;
};

void
VtkWriter::pointValues(const std::vector<std::size_t>& offsets, std::size_t size)
{
  std::vector<RecordMove> moves;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    appendCopy(moves, {offsets[i], i * size, size});
  const std::size_t step = offsets.size() * size;
  const std::size_t point_step = cloud_.layout().point_step;
  const auto fill = [&](std::uint8_t* to, std::size_t first, std::size_t count) {
    const std::uint8_t* const from = cloud_.data() + first * point_step;
    moveRecords(moves, from, point_step, to, step, count);
    swapValues(to, size, size, count * offsets.size());
  };
  writeRecords(file_, points_, step, fill);
  text("\n");
}

void
VtkWriter::polygons(const TriangleMesh& mesh)
{
  const std::size_t count = mesh.triangles.size();
  text("POLYGONS " + std::to_string(count) + " " + std::to_string(4 * count) + "\n");
  constexpr std::int32_t corners = 3;
  constexpr std::size_t word = sizeof(corners);
  const auto fill = [&](std::uint8_t* to, std::size_t first, std::size_t some) {
    for (std::size_t i = 0; i < some; ++i) {
      std::memcpy(to + i * 4 * word, &corners, word);
      std::memcpy(to + (i * 4 + 1) * word, mesh.triangles[first + i].data(), 3 * word);
    }
    swapValues(to, word, word, 4 * some);
  };
  writeRecords(file_, count, 4 * word, fill);
  text("\n");
}

} // namespace

void
writeVtk(OutputFile& file,
         const CloudRows& cloud,
         const MeshColumns& columns,
         const TriangleMesh& mesh)
{
  VtkWriter writer(file, cloud);
  const std::string count = std::to_string(writer.points());
  writer.text("# vtk DataFile Version 3.0\nacmap triangle mesh\nBINARY\n"
              "DATASET POLYDATA\nPOINTS " +
              count + " float\n");
  writer.pointValues({columns.coordinates.begin(), columns.coordinates.end()},
                     sizeof(float));
  writer.polygons(mesh);
  if (columns.colour.empty() && columns.normal.empty() && columns.scalars.empty())
    return;
  writer.text("POINT_DATA " + count + "\n");
  if (!columns.colour.empty()) {
    writer.text("COLOR_SCALARS scalars " + std::to_string(columns.colour.size()) +
                "\n");
    writer.pointValues(columns.colour, 1);
  }
  if (!columns.normal.empty()) {
    writer.text("NORMALS normals float\n");
    writer.pointValues(columns.normal, sizeof(float));
  }
  if (columns.scalars.empty())
    return;
  writer.text("FIELD fields " + std::to_string(columns.scalars.size()) + "\n");
  for (const ScalarColumn& scalar : columns.scalars) {
    writer.text(scalar.name + " 1 " + count + " " + vtkTypeOf(scalar.datatype) + "\n");
    writer.pointValues({scalar.offset}, sizeOfType(scalar.datatype));
  }
}

} // namespace pcl::acmap
