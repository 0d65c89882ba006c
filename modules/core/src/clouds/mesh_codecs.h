#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/output_file.h>
#include <pcl/core/triangle_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief A value per point that a mesh file stores with its own name. */
struct ScalarColumn {
  std::string name;
  std::uint8_t datatype = 0;
  std::size_t offset = 0; // in bytes, in a point
};

/** \brief Fields of a cloud that a mesh file stores, as offsets in a point. */
struct MeshColumns {
  std::array<std::size_t, 3> coordinates{};
  std::vector<std::size_t> normal; // x y z, or empty
  std::vector<std::size_t> colour; // red green blue (alpha), or empty
  std::vector<ScalarColumn> scalars;
};

/** \brief Selects the fields of a cloud.
 *
 * Fields of several values, of a type that mesh files do not support (64-bit integers,
 * boolean), or whose name is not a word or is a duplicate are omitted.
 * \throws BadArgumentException if x, y, z are not float32, or a field or a point is
 * outside the data */
MeshColumns
sortColumns(const CloudRows& cloud);

/** \brief Implementations of \ref saveTriangleMesh; the mesh has been checked before.
 */
void
writePly(OutputFile& file,
         const CloudRows& cloud,
         const MeshColumns& columns,
         const TriangleMesh& mesh);
void
writeVtk(OutputFile& file,
         const CloudRows& cloud,
         const MeshColumns& columns,
         const TriangleMesh& mesh);

/** \brief Reads the faces of an OBJ for \ref loadTriangleMesh. Corners may contain
 * indices of texture and normal, and may be relative to the last vertex (negative).
 * \throws InputFileException when a corner is not a number, or out of range */
TriangleMesh
readObjFaces(ByteSource& source);

/** \brief Reads the faces of a PLY for \ref loadTriangleMesh.
 * \throws InputFileException when the data do not match their header */
TriangleMesh
readPlyFaces(ByteSource& source);

} // namespace pcl::acmap
