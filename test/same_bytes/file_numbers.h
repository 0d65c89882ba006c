#pragma once

#include <map>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Numbers by file and field, in their order in the file.
 *
 * Digits of file names and JSON array indices are replaced by `#`, so that all
 * textures of a map are combined, and so are all its planes. */
using FileNumbers = std::map<std::string, std::vector<double>>;

/** \brief Reads all files of a folder and its subfolders: fields of points, corners of
 * faces, values of images, numbers in JSON and text. Ignores reports, their pictures,
 * names of files, and what has the same numbers as other files: map.glb (map.obj), map.html,
 * map.ifc and floor plans (map.json).
 * \throws std::runtime_error with the name of a file of unknown type */
FileNumbers
numbersIn(const std::string& folder);

} // namespace pcl::acmap::test
