#pragma once

#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <string>

namespace pcl::acmap {

/** \brief Writes a cloud as PCD with the planes of its points, \ref withLabels.
 * \param[in] file given up, as it may be large */
void
saveLabels(const std::string& path,
           PointCloudFile file,
           const std::vector<std::int32_t>& planes);

/** \brief Writes the mesh as PLY: with the voted normals, `curvature` (1 - saliency),
 * `vertex_class` (\ref VertexClass) and `label`. */
void
saveNormals(const std::string& path, const MappedPlanes& found);

/** \brief From beside its sensor, without faces that look away. */
SceneView
sceneViewOf(const MappedPlanes& found);

/** \brief Draws the mesh as PNG, in colours by plane, without faces that look away. */
void
savePicture(const std::string& path, const MappedPlanes& found);

} // namespace pcl::acmap
