#pragma once

#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <string>

namespace pcl::acmap {

/** \brief Writes a cloud as PCD with the plane of each point, see \ref withLabels.
 * \param[in] file passed by value and released, as it may be large */
void
saveLabels(const std::string& path,
           PointCloudFile file,
           const std::vector<std::int32_t>& planes);

/** \brief Writes the mesh as PLY: with the voted normals, `curvature` (1 - saliency),
 * `vertex_class` (\ref VertexClass) and `label`. */
void
saveNormals(const std::string& path, const MappedPlanes& found);

/** \brief A view from a position next to the sensor, with back faces culled. */
SceneView
sceneViewOf(const MappedPlanes& found);

/** \brief Draws the mesh as PNG, coloured by plane, with back faces culled. */
void
savePicture(const std::string& path, const MappedPlanes& found);

} // namespace pcl::acmap
