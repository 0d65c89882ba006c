#pragma once

#include <array>

namespace pcl::acmap {

/** \brief Weights at each quarter pixel, of the pixel before a position, the pixel
 * itself and the two behind it: cubic convolution (Keys, 1981). */
inline constexpr std::array<std::array<float, 4>, 4> cubic_weights{
    {{0.0F, -0.0703125F, -0.0625F, -0.0234375F},
     {1.0F, 0.8671875F, 0.5625F, 0.2265625F},
     {0.0F, 0.2265625F, 0.5625F, 0.8671875F},
     {0.0F, -0.0234375F, -0.0625F, -0.0703125F}}};

} // namespace pcl::acmap
