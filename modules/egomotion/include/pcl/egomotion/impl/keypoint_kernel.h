#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Brightness of the pixels of an organized cloud, row by row, 0 to 255. */
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> values;
};

/** \brief Settings of \ref gradientMaxima; see GradientMaximumKeypoint. */
struct KeypointSettings {
  float min_gradient = 0.5F;             ///< grey levels per pixel
  std::size_t maximum = 1000;            ///< maximum number of keypoints
  int cell_width = 32, cell_height = 24; ///< size of the cells for spreading, pixels
  unsigned threads = 0;                  ///< 0 = all
};

/** \brief Calls visit (field, value) for each field but the threads; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const KeypointSettings& settings, Visitor&& visit)
{
  visit({"min_gradient"}, settings.min_gradient);
  visit({"maximum"}, settings.maximum);
  visit({"cell_width", "px"}, settings.cell_width);
  visit({"cell_height", "px"}, settings.cell_height);
}

/** \brief Counts of \ref gradientMaxima. */
struct KeypointCounts {
  std::size_t maxima = 0;        ///< strict maxima of at least the minimum gradient
  std::size_t without_place = 0; ///< maxima without a point
  std::size_t left_out = 0;      ///< maxima with a point beyond the maximum number
};

/** \brief Finds the pixels that are strict local maxima of the gradient of the image
 * (of the brightness smoothed with a Gaussian of one pixel) among their eight
 * neighbours and that have a point. If there are more than the maximum number, those
 * with less than half the gradient of the last one that would be selected by strength
 * alone are excluded; of the others, the strongest of each cell is selected, then the
 * second strongest and so on, so that they are spread over the image.
 * \param[in] has_place one value per pixel, not 0 if the pixel has a point
 * \return pixels in ascending order */
ACMAP_EXPORT std::vector<std::int32_t>
gradientMaxima(const GreyImage& image,
               const std::vector<std::uint8_t>& has_place,
               const KeypointSettings& settings,
               KeypointCounts& counts);

} // namespace pcl::acmap
