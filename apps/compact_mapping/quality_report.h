#pragma once

#include "stage_log.h"

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/texture/floor_plan.h>

namespace pcl::acmap {

/** \brief Tells how good a map is, and reports it as "quality" and next_positions. */
void
tellQuality(const CompactMappingReport& report, StageLog& log);

/** \brief What the picture of the report shows of a map, seen from above: "rooms" and "furniture"
 * (outlines), "walls" (x, y, x, y, plane), "openings" (x, y, x, y), "unseen" (x, y, side of the square;
 * and its role), all in metres of the plan; "axes", the axes of the plan in the map frame. */
nlohmann::ordered_json
planOf(const CompactMap& map, const FloorPlan& plan);

} // namespace pcl::acmap
