#pragma once

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The files of a recording. */
struct BagFiles {
  std::vector<std::string> paths;   ///< in the order of their recording
  std::vector<std::string> remarks; ///< warnings, one per line
};

/** \brief Finds the files of a bag: those that the metadata.yaml of a folder names, or
 * those whose names are numbered from 0; a file is one itself.
 * \throws InputFileException if a file is missing or packed as a whole, or a folder has
 * several recordings or none */
BagFiles
findBagFiles(const std::string& path);

} // namespace pcl::acmap
