#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief Reads what an earlier run noted for the next one.
 * \return a discarded value when there is no such file, it is no JSON, or nested deeper
 * than any run nests it */
nlohmann::ordered_json
readJson(const std::string& path);

/** \brief Whether a name that such a file tells stays in its folder: the file may be
 * anybody's. */
bool
isPlainName(const std::string& name);

} // namespace pcl::acmap
