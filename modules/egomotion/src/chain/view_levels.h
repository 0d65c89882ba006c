#pragma once

#include <pcl/egomotion/impl/egomotion_kernel.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Position of a pixel in an image, row by row. */
inline std::size_t
pixelAt(int width, int column, int row)
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

/** \brief A view at full or reduced size. */
struct ViewLevel {
  GreyImage image;
  std::vector<Eigen::Vector3f> points; ///< metres; NaN if no surface fills the pixel
  float noise = 1;                     ///< standard deviation of a value, grey levels
  int scale = 1;                       ///< size of a pixel in pixels of the view

  /** \brief The pixel of the view in the middle of a pixel of this level. */
  std::size_t
  viewPixel(std::int32_t pixel, int view_width) const
  {
    const auto x = static_cast<std::size_t>(pixel % image.width * scale + scale / 2);
    const auto y = static_cast<std::size_t>(pixel / image.width * scale + scale / 2);
    return y * static_cast<std::size_t>(view_width) + x;
  }
};

/** \brief Levels of full, half, quarter and eighth size; fewer for a small view. */
std::vector<ViewLevel>
viewLevels(const CameraView& view);

/** \brief Standard deviation of the noise of an image, grey levels. */
float
imageNoise(const GreyImage& image);

} // namespace pcl::acmap
