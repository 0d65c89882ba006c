#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief An image of 16 bit depths, in row-major order from the top. */
struct DepthImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint16_t> pixels;
};

/** \brief Reads a grey PNG of 16 bits.
 * \throws std::runtime_error when the file is not one */
DepthImage
readDepthImage(const std::string& path);

} // namespace pcl::acmap::bench
