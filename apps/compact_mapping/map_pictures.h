#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/output_folder.h>
#include <pcl/pipeline/plane_mapping_types.h>

namespace pcl::acmap {

/** \brief Draws mesh.png, planes.png, outside.png, inside.png and floor_plan.png.
 * \throws OutputFileException when one could not be written */
void
savePictures(const OutputFolder& folder,
             const MappedPlanes& found,
             const CompactMap& map);

} // namespace pcl::acmap
