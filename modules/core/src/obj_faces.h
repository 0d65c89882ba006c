#pragma once

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

class ByteSource;

/** \brief Reads the faces of an OBJ behind \ref loadTriangleMesh; corners may name texture
 * and normal, and may count backwards from the last vertex.
 * \throws InputFileException when a corner is no number, or outside of the vertices */
TriangleMesh
readObjFaces(ByteSource& source);

} // namespace pcl::acmap
