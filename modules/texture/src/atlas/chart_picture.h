#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Width and height of a chart after halving it, rounded up. */
Eigen::Vector2i
halvedSize(const RgbImage& image, std::int32_t halvings);

/** \brief Brightens or darkens a channel of a colour, rounded, at most 255. */
std::uint8_t
exposed(double value, double exposure);

/** \brief Enlarges a halved picture to the size of its chart: bilinear between the
 * centres of its texels, constant beyond the outer ones. The colours are divided by the
 * exposure.
 * \param[in] small of \ref halvedSize
 * \param[in,out] chart gives the sizes, gets the colours */
void
enlarge(const RgbImage& small, double exposure, TexturePicture& chart);

/** \brief The colours of a chart as they are stored. */
struct ChartPicture {
  std::int32_t halvings = 0;
  RgbImage image; ///< of \ref halvedSize, multiplied by the exposure
};

/** \brief Settings of \ref pictureOf. */
struct PictureSettings {
  double exposure = 1;

  /** \brief The picture is halved as long as its difference from the chart, enlarged
   * again, has a root mean square of at most this, and of at most three times this in
   * each block of 8 x 8 texels; levels of 255. */
  double tolerance = 0;
  std::int32_t min_halvings = 0;
};

/** \brief Makes the picture of a chart, at the lowest resolution that the tolerance
 * permits: a chart of one colour becomes a single texel. Texels that are unknown are
 * grey inside of the polygon. Outside, they continue the colours, so that interpolation
 * and image compression find no edge there.
 * \param[in] cover for each texel, is its centre inside of the polygon? */
ChartPicture
pictureOf(const TexturePicture& chart,
          const std::vector<bool>& cover,
          const PictureSettings& settings);

} // namespace pcl::acmap
