#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/triangle_mesh.h>

#include <string>

namespace pcl {

/** \brief Writes a triangle mesh as binary PLY or legacy binary VTK; the ending of the
 * name tells which.
 *
 * All points of the cloud are written, in their order, so that indices keep their
 * meaning; x y z as float, colour (`rgb`, `rgba`), normals and scalar fields where the
 * cloud has them; `wall_depth` as a face property of the PLY where the mesh has it. Points
 * that are not finite are written as they are. The file is written beside
 * and renamed into place.
 * \throws OutputFileException when the file could not be written whole: unknown ending,
 * missing folder, no permission, disk full; an older file of that name is then untouched
 * \throws BadArgumentException when the mesh has an index outside the cloud
 */
void
saveTriangleMesh(const std::string& path,
                 const PCLPointCloud2& cloud,
                 const TriangleMesh& mesh);

} // namespace pcl
