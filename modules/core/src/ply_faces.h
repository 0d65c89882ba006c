#pragma once

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

class ByteSource;

/** \brief Reads the faces of a PLY for \ref loadTriangleMesh.
 * \throws InputFileException when the data do not match their header */
TriangleMesh
readPlyFaces(ByteSource& source);

} // namespace pcl::acmap
