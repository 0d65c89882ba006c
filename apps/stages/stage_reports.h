#pragma once

#include <pcl/core/report.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/surface/dewall_types.h>

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The fields of a stage's report, and its seconds; remarks go elsewhere. */
nlohmann::ordered_json
jsonOf(const ConsolidationReport& report);

nlohmann::ordered_json
jsonOf(const DeWallReport& report);

/** \brief The seconds of the steps of a stage. */
nlohmann::ordered_json
secondsOf(const Report& report);

/** \brief Share of a whole, as a text with %. */
std::string
percent(std::size_t part, std::size_t whole);

} // namespace pcl::acmap
