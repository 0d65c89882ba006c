#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

#include <string>

namespace pcl {

/** \brief Writes a triangle mesh as binary PLY or legacy binary VTK; the ending of the
 * name tells which, in any case.
 *
 * All points of the cloud are written, in their order, so that indices keep their
 * meaning; those that are not finite are written as they are. Beside x y z go the colour
 * (`rgb`, `rgba`), the normals and the scalar fields of the cloud, under their names;
 * fields of several values or of 64-bit integers are left out. `wall_depth` becomes a
 * face property of the PLY. The file is written beside its target and renamed into place.
 * \param[in] path the file; metres and frame are those of the cloud
 * \param[in] cloud the vertices; x y z float32
 * \param[in] mesh the faces
 * \throws OutputFileException when the file could not be written whole: unknown ending,
 * missing folder, no permission, disk full; an older file of that name is then untouched
 * \throws BadArgumentException when the mesh has an index outside the cloud, or the
 * fields of the cloud are not inside its data. \ingroup core
 */
ACMAP_EXPORT void
saveTriangleMesh(const std::string& path,
                 const PCLPointCloud2& cloud,
                 const TriangleMesh& mesh);

/** \brief Reads the faces of a PLY or OBJ, polygons as fans of triangles; their corners
 * count in the cloud that \ref loadPointCloud gives for the same file. A face property
 * `wall_depth` of a PLY becomes \ref TriangleMesh::wall_depth.
 * \return no triangle where the file has no faces
 * \throws InputFileException as \ref loadPointCloud, and when a face has a corner outside
 * of the vertices, or a `wall_depth` that is none of 0 to 255. \ingroup core */
ACMAP_EXPORT TriangleMesh
loadTriangleMesh(const std::string& path);

} // namespace pcl
