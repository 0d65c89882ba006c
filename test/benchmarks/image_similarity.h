#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Structural similarity (SSIM) of two images. */
struct Similarity {
  double mean = 0; ///< over the windows, 1 for equal images
  std::size_t windows = 0;
};

/** \brief Compares brightness over windows of 8 x 8 pixels, 4 apart; windows with
 * unknown pixels are ignored.
 * \param[in] a, b three values per pixel
 * \param[in] is_known one value per pixel */
Similarity
structuralSimilarity(const std::vector<std::uint8_t>& a,
                     const std::vector<std::uint8_t>& b,
                     const std::vector<std::uint8_t>& is_known,
                     std::size_t width);

} // namespace pcl::acmap::bench
