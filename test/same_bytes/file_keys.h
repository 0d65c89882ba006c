#pragma once

#include <map>
#include <string>

namespace pcl::acmap::test {

/** \brief Keys of each object in each report.json, map.json and stage.json of a folder:
 * `map/map.json /planes/#` and `area, boundary, ...`, in order of the alphabet.
 *
 * Of a stage.json only those of what the stage was made of; its results and what was told
 * of it are in other files, too. */
std::map<std::string, std::string>
keysIn(const std::string& folder);

} // namespace pcl::acmap::test
