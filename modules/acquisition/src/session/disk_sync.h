#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Waits until a file and its name in its folder are on the disk: a power failure
 * does not take them any more.
 * \throws OutputFileException when the disk did not take them */
void
syncToDisk(const std::string& path);

} // namespace pcl::acmap
