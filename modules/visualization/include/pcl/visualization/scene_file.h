#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_reader.h>
#include <pcl/core/triangle_mesh.h>

#include <string>

namespace pcl {

/** \brief A mesh or a cloud read from a file; without triangles it is a cloud.
 * \ingroup visualization */
struct SceneFile {
  PointCloudFile points;
  TriangleMesh mesh;
};

/** \brief Reads what \ref showScene can show: a cloud (as \ref loadPointCloud) or a mesh
 * (PLY or OBJ with faces, legacy VTK of polygons or triangle strips).
 * \param[in] reader with what is stated of the file
 * \throws InputFileException with file name and error \ingroup visualization */
ACMAP_EXPORT SceneFile
loadScene(const std::string& path, const PointCloudReader& reader = {});

} // namespace pcl
