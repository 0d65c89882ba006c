#pragma once

#include "mesh_columns.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/output_file.h>
#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

/** \brief Implementations of \ref saveTriangleMesh; the mesh has been checked before.
 */
void
writePly(OutputFile& file,
         const PCLPointCloud2& cloud,
         const MeshColumns& columns,
         const TriangleMesh& mesh);
void
writeVtk(OutputFile& file,
         const PCLPointCloud2& cloud,
         const MeshColumns& columns,
         const TriangleMesh& mesh);

} // namespace pcl::acmap
