#pragma once

#include <pcl/acquisition/random_line_pattern.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Ten patterns, as in the paper. */
inline std::vector<RgbImage>
drawPatterns()
{
  constexpr std::uint32_t patterns = 10;
  RandomLinePattern lines;
  std::vector<RgbImage> images;
  for (std::uint32_t i = 0; i < patterns; ++i)
    images.push_back(lines.generate(i));
  return images;
}

} // namespace pcl::acmap::bench
