#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief Reads a state file of an earlier run.
 * \return a discarded value when there is no such file, it is no JSON, or nested deeper
 * than any run nests it */
nlohmann::ordered_json
readJson(const std::string& path);

/** \brief Does a file name from such a file stay in its folder? The file may come from
 * an untrusted source. */
bool
isPlainName(const std::string& name);

} // namespace pcl::acmap
