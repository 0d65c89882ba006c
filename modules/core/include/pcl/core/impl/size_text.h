#pragma once

#include <pcl/core/build_config.h>

#include <cmath>
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

/** \brief "529 : 1", or "1 : 3" for a ratio below 1: what should be smaller is larger. */
inline std::string
ratioText(double ratio)
{
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(0);
  if (ratio >= 1)
    text << std::floor(ratio) << " : 1";
  else if (ratio > 0)
    text << "1 : " << std::ceil(1 / ratio);
  else
    text << "0 : 1";
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
