#pragma once

#include <pcl/core/build_config.h>

#include <sstream>
#include <string>

namespace pcl::acmap {

/** \brief Metres in a unit, as an option takes them: the feet of two countries differ in the
 * sixth digit. */
inline std::string
unitText(double metres)
{
  constexpr int digits = 7;
  std::ostringstream text;
  text.precision(digits);
  text << metres;
  return text.str();
}

} // namespace pcl::acmap
