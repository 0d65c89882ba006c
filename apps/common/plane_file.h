#pragma once

#include <pcl/core/plane_patch.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Writes planes as JSON, in their order, numbers with as many digits as it takes
 * to read the same ones back; what is not known is null. The file is written beside its
 * target and renamed into place.
 * \throws OutputFileException when it could not be written whole */
void
savePlanes(const std::string& path, const std::vector<PlanePatch>& planes);

} // namespace pcl::acmap
