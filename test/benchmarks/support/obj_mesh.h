#pragma once

#include "mesh_checker.h"

#include <string>

namespace pcl::acmap::bench {

/** \brief A reference surface: vertices and triangles of an OBJ file. */
struct ObjMesh {
  test::Points points;
  test::Triangles triangles;
};

/** \brief Reads positions and faces; polygons are split into fans.
 * \throws InputFileException when the file cannot be opened or has no face */
ObjMesh
loadObjMesh(const std::string& path);

} // namespace pcl::acmap::bench
