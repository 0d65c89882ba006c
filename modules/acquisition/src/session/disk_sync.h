#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Waits until a file and its entry in its folder are on the disk, so that they
 * survive a power failure.
 * \throws OutputFileException when writing to the disk failed */
void
syncToDisk(const std::string& path);

} // namespace pcl::acmap
