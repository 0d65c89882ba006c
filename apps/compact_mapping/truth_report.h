#pragma once

#include <pcl/pipeline/map_comparison.h>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Those figures as a report has them; `compactness` is null until it is known. */
nlohmann::ordered_json
toJson(const MapFigures& figures);

/** \brief Those figures as lines of a summary, but for the compactness, which every map
 * has: names and values. */
std::vector<std::pair<std::string, std::string>>
linesOf(const MapFigures& figures);

} // namespace pcl::acmap
