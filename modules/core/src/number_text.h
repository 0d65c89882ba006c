#pragma once

#include <array>
#include <charconv>
#include <string>

namespace pcl::acmap {

/** \brief Returns the shortest text from which the same number is read back,
 * independent of the locale. */
template <typename Real>
std::string
textOf(Real value)
{
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

} // namespace pcl::acmap
