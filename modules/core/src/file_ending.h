#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Returns the extension of a file name with its dot, in lower case. */
std::string
lowerEnding(const std::string& path);

} // namespace pcl::acmap
