#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Structural similarity (SSIM) of two images. */
struct Similarity {
  double mean = 0; ///< over the windows, 1 for the same
  std::size_t windows = 0;
};

/** \brief Of brightness, over windows of 8 x 8 pixels, 4 apart, that are known as a whole.
 * \param[in] a, b three values a pixel
 * \param[in] is_known one a pixel */
Similarity
structuralSimilarity(const std::vector<std::uint8_t>& a,
                     const std::vector<std::uint8_t>& b,
                     const std::vector<std::uint8_t>& is_known,
                     std::size_t width);

} // namespace pcl::acmap::bench
