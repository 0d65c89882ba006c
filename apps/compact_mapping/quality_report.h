#pragma once

#include "stage_log.h"

#include <pcl/pipeline/compact_mapping_types.h>

namespace pcl::acmap {

/** \brief Tells how good a map is, and reports it as "quality" and next_positions. */
void
tellQuality(const CompactMappingReport& report, StageLog& log);

} // namespace pcl::acmap
