#pragma once

#include <string>

namespace pcl::acmap {

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
