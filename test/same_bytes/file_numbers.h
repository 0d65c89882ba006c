#pragma once

#include <map>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Numbers of files by file and field, in the order in which they stand there.
 *
 * Digits of a file's name and places in a JSON array count as `#`, so that all textures of
 * a map are one file, and all its planes one plane. */
using FileNumbers = std::map<std::string, std::vector<double>>;

/** \brief Reads all files of a folder and those below it: fields of points, corners of
 * faces, values of images, numbers of JSON and text. Reports, what is drawn of them, and
 * map.glb, which holds the numbers of map.obj, are left out.
 * \throws std::runtime_error naming a file of a kind that is not known */
FileNumbers
numbersIn(const std::string& folder);

} // namespace pcl::acmap::test
