#include "clouds/mesh_codecs.h"
#include "files/record_moves.h"
#include "files/record_writer.h"

#include <cstring>
#include <string>

namespace pcl::acmap {

namespace {

const char*
plyTypeOf(std::uint8_t datatype)
{
  switch (datatype) {
  case PCLPointField::INT8:
    return "char";
  case PCLPointField::UINT8:
    return "uchar";
  case PCLPointField::INT16:
    return "short";
  case PCLPointField::UINT16:
    return "ushort";
  case PCLPointField::INT32:
    return "int";
  case PCLPointField::UINT32:
    return "uint";
  case PCLPointField::FLOAT32:
    return "float";
  default:
    return "double";
  }
}

/** \brief The properties of a vertex: their header lines, and the moves that copy their
 * bytes. */
struct VertexRecord {
  std::string header;
  std::vector<RecordMove> moves;
  std::size_t bytes = 0;

  void
  add(const std::string& name, std::uint8_t datatype, std::size_t offset)
  {
    header += std::string("property ") + plyTypeOf(datatype) + " " + name + "\n";
    const std::size_t size = sizeOfType(datatype);
    appendCopy(moves, {offset, bytes, size});
    bytes += size;
  }

  void
  addAll(const std::vector<std::size_t>& offsets,
         const char* const* names,
         std::uint8_t datatype)
  {
    for (std::size_t i = 0; i < offsets.size(); ++i)
      add(names[i], datatype, offsets[i]);
  }
};

VertexRecord
describeVertex(const MeshColumns& columns)
{
  static constexpr const char* coordinates[] = {"x", "y", "z"};
  static constexpr const char* normal[] = {"nx", "ny", "nz"};
  static constexpr const char* colour[] = {"red", "green", "blue", "alpha"};
  VertexRecord vertex;
  vertex.addAll({columns.coordinates.begin(), columns.coordinates.end()},
                coordinates,
                PCLPointField::FLOAT32);
  vertex.addAll(columns.normal, normal, PCLPointField::FLOAT32);
  vertex.addAll(columns.colour, colour, PCLPointField::UINT8);
  for (const ScalarColumn& scalar : columns.scalars)
    vertex.add(scalar.name, scalar.datatype, scalar.offset);
  return vertex;
}

void
writeFaces(OutputFile& file, const TriangleMesh& mesh)
{
  const bool has_depth = !mesh.wall_depth.empty();
  constexpr std::size_t corners = sizeof(TriangleMesh::Triangle);
  const std::size_t step = 1 + corners + (has_depth ? 1 : 0);
  const auto fill = [&](std::uint8_t* to, std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i, to += step) {
      to[0] = 3;
      std::memcpy(to + 1, mesh.triangles[i].data(), corners);
      if (has_depth)
        to[1 + corners] = mesh.wall_depth[i];
    }
  };
  writeRecords(file, mesh.triangles.size(), step, fill);
}

} // namespace

void
writePly(OutputFile& file,
         const CloudRows& cloud,
         const MeshColumns& columns,
         const TriangleMesh& mesh)
{
  const std::size_t points = cloud.size(), point_step = cloud.layout().point_step;
  const VertexRecord vertex = describeVertex(columns);
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                       std::to_string(points) + "\n" + vertex.header + "element face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\n";
  if (!mesh.wall_depth.empty())
    header += "property uchar wall_depth\n";
  header += "end_header\n";
  file.write(header.data(), header.size());
  const auto fill = [&](std::uint8_t* to, std::size_t first, std::size_t count) {
    moveRecords(vertex.moves,
                cloud.data() + first * point_step,
                point_step,
                to,
                vertex.bytes,
                count);
  };
  writeRecords(file, points, vertex.bytes, fill);
  writeFaces(file, mesh);
}

} // namespace pcl::acmap
