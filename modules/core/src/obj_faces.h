#pragma once

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

class ByteSource;

/** \brief Reads the faces of an OBJ for \ref loadTriangleMesh. Corners may contain
 * indices of texture and normal, and may be relative to the last vertex (negative).
 * \throws InputFileException when a corner is not a number, or out of range */
TriangleMesh
readObjFaces(ByteSource& source);

} // namespace pcl::acmap
