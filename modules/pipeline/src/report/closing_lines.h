#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief The last lines of a summary, name and value, by the report of a map: is it good, what is
 * in it, how exact is it, and what was not seen. */
std::vector<std::pair<std::string, std::string>>
closingLines(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
