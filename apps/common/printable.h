#pragma once

#include <string>

namespace pcl::acmap {

/** \brief A text as a terminal may show it: control characters, and bytes that are no
 * UTF-8, become question marks. Messages quote files, which hold anything. */
std::string
printable(const std::string& text);

} // namespace pcl::acmap
