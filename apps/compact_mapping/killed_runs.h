#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Removes the hidden files and folders that runs which were killed left in a folder:
 * those named after a process that is no more. What cannot be removed stays. */
void
removeLeftovers(const std::string& folder);

} // namespace pcl::acmap
