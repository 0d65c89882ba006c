#pragma once

#include <algorithm>
#include <string>

namespace pcl::acmap {

/** \brief What an exception says, for a message around it: PCL puts ": " before every
 * message. */
inline std::string
faultText(std::string what)
{
  what.erase(0, std::min(what.find_first_not_of(": "), what.size()));
  return what;
}

} // namespace pcl::acmap
