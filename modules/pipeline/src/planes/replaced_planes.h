#pragma once

#include <pcl/pipeline/plane_mapping_types.h>

namespace pcl::acmap {

/** \brief Removes the planes for which cylinders stand from planes, labels and the
 * neighbours of edges. Clears CylinderPatch::planes, whose numbers are not valid any
 * more. */
void
removeReplacedPlanes(MappedPlanes& mapped);

} // namespace pcl::acmap
