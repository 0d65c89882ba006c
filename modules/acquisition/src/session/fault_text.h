#pragma once

#include <algorithm>
#include <string>

namespace pcl::acmap {

/** \brief Message of an exception, for use within another message: removes the ": "
 * that PCL puts before every message. */
inline std::string
faultText(std::string what)
{
  what.erase(0, std::min(what.find_first_not_of(": "), what.size()));
  return what;
}

} // namespace pcl::acmap
