#pragma once

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

class ByteSource;

/** \brief Reads the faces behind \ref loadTriangleMesh.
 * \throws InputFileException when the bytes are not what their header says */
TriangleMesh
readPlyFaces(ByteSource& source);

} // namespace pcl::acmap
