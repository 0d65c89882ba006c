#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace pcl::acmap {

/** \brief Extension of a file name with its dot, in lower case. */
inline std::string
endingOf(const std::filesystem::path& path)
{
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

} // namespace pcl::acmap
