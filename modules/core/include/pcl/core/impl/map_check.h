#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

namespace pcl::acmap {

/** \brief Checks that a map can be stored in a map file and read again.
 * \throws BadArgumentException for invalid planes, charts, observations or poses
 * \ingroup core */
ACMAP_EXPORT void
requireConsistent(const CompactMap& map);

} // namespace pcl::acmap
