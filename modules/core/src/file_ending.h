#pragma once

#include <string>

namespace pcl::acmap {

/** \brief The ending of a file's name with its dot, in small letters. */
std::string
lowerEnding(const std::string& path);

} // namespace pcl::acmap
