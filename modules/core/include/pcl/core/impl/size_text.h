#pragma once

#include <pcl/core/build_config.h>

#include <sstream>
#include <string>

namespace pcl::acmap {

/** \brief A number with three significant digits, for messages. */
inline std::string
shortNumber(double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

/** \brief "640 x 480". */
template <typename Number>
std::string
sizeText(Number width, Number height)
{
  return std::to_string(width) + " x " + std::to_string(height);
}

/** \brief The same of an image, a rig or an organized cloud: of all that has a width
 * and a height. */
template <typename Sized>
std::string
sizeText(const Sized& sized)
{
  return sizeText(sized.width, sized.height);
}

} // namespace pcl::acmap
