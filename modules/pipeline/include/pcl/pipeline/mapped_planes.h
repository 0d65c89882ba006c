#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/pipeline/plane_mapping_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief A map of what \ref PlaneMapping has found: planes, cylinders, boxes and recesses,
 * without textures, names and poses. \ingroup pipeline */
ACMAP_EXPORT CompactMap
mapOf(const MappedPlanes& found);

/** \brief Label of each point of the input, from 0: the number of its plane, or the
 * number of planes plus that of its cylinder; -1 for none. \ingroup pipeline */
ACMAP_EXPORT std::vector<std::int32_t>
labelsOf(const MappedPlanes& found);

/** \brief The same of each vertex of the mesh. \ingroup pipeline */
ACMAP_EXPORT std::vector<std::int32_t>
labelsOfVertices(const MappedPlanes& found);

/** \brief Writes the mesh as PLY or VTK with all fields of its vertices, the voted normals,
 * `curvature` (1 - saliency), `vertex_class` (\ref VertexClass), and `label`: that of
 * \ref labelsOfVertices + 1, 0 for none.
 * \throws OutputFileException when it could not be written completely \ingroup pipeline */
ACMAP_EXPORT void
saveMappedMesh(const std::string& path, const MappedPlanes& found);

} // namespace pcl
