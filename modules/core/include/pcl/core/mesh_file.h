#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

#include <string>

namespace pcl {

/** \brief Writes a triangle mesh as binary PLY or legacy binary VTK, depending on the
 * file extension (case-insensitive).
 *
 * All points of the cloud are written in their order, so that indices stay valid;
 * points that are not finite are written unchanged. In addition to x y z, the colour
 * (`rgb`, `rgba`), the normals and the scalar fields of the cloud are written with
 * their names; fields of several values or of 64-bit integers are omitted. `wall_depth`
 * becomes a face property of the PLY. The file is written to a temporary file in the
 * same folder and then renamed.
 * \param[in] path the file; metres and frame are those of the cloud
 * \param[in] cloud the vertices; x y z float32
 * \param[in] mesh the faces
 * \throws OutputFileException when the file could not be written completely: unknown
 * extension, missing folder, no permission, disk full; an existing file of that name is
 * not changed
 * \throws BadArgumentException if there is no cloud, the mesh has an index outside of it,
 * or its fields are not inside its data. \ingroup core */
ACMAP_EXPORT void
saveTriangleMesh(const std::string& path,
                 const CloudRows& cloud,
                 const TriangleMesh& mesh);

/** \brief The same for a cloud that is not shared. \ingroup core */
inline void
saveTriangleMesh(const std::string& path,
                 const PCLPointCloud2& cloud,
                 const TriangleMesh& mesh)
{
  saveTriangleMesh(path, CloudRows::of(cloud), mesh);
}

/** \brief Reads the faces of a PLY or OBJ. Polygons are converted to triangle fans;
 * their corners are indices into the cloud that \ref loadPointCloud returns for the
 * same file. A face property `wall_depth` of a PLY becomes
 * \ref TriangleMesh::wall_depth.
 * \return no triangles if the file has no faces
 * \throws InputFileException as \ref loadPointCloud, and if the index of a corner is
 * out of range, or a `wall_depth` is not in 0 to 255. \ingroup core */
ACMAP_EXPORT TriangleMesh
loadTriangleMesh(const std::string& path);

} // namespace pcl
