#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/texture/floor_plan.h>

#include <nlohmann/json.hpp>

namespace pcl::acmap {

/** \brief See \ref mapDetailsText. */
nlohmann::ordered_json
detailsOfMap(const CompactMap& map);

/** \brief See \ref planDetailsText. */
nlohmann::ordered_json
detailsOfPlan(const CompactMap& map, const FloorPlan& plan);

} // namespace pcl::acmap
