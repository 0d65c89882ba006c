#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Brightness of an organized cloud's pixels, row by row, 0 to 255. */
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> values;
};

/** \brief Settings of \ref gradientMaxima; see GradientMaximumKeypoint. */
struct KeypointSettings {
  float least_gradient = 0.5F;           ///< grey levels a pixel
  std::size_t most = 1000;               ///< keypoints
  int cell_width = 32, cell_height = 24; ///< pixels, of the cells that share them
  unsigned threads = 0;                  ///< 0 = all
};

/** \brief What \ref gradientMaxima met. */
struct KeypointCounts {
  std::size_t maxima = 0;        ///< strict, of at least the least gradient
  std::size_t without_place = 0; ///< of these
  std::size_t left_out = 0;      ///< maxima with a place beyond the number asked for
};

/** \brief Pixels that are strict local maxima of the image's gradient (of brightness
 * smoothed with a Gaussian of one pixel) among their eight neighbours, and have a place.
 * Where there are more than asked for, those of less than half the gradient at which
 * strength alone would end are left out; of the others each cell gives its strongest, then
 * its second and so on, so that they spread over the image.
 * \param[in] has_place one a pixel, not 0 where a point lies there
 * \return pixels, rising */
ACMAP_EXPORT std::vector<std::int32_t>
gradientMaxima(const GreyImage& image,
               const std::vector<std::uint8_t>& has_place,
               const KeypointSettings& settings,
               KeypointCounts& counts);

} // namespace pcl::acmap
