#pragma once

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap::texturing {

/** Brightness of a part of a sheet, in blocks of texels; NaN where it is unknown. */
struct BlockImage {
  static constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

  std::int32_t left = 0, top = 0, width = 0, height = 0; ///< blocks
  std::vector<float> values;                             ///< row by row

  /** Covers a box of blocks, both corners included; all of it is unknown then. */
  void
  cover(const Eigen::AlignedBox2i& box)
  {
    left = box.min().x();
    top = box.min().y();
    width = box.sizes().x() + 1;
    height = box.sizes().y() + 1;
    values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  unknown);
  }

  float
  at(std::int32_t column, std::int32_t row) const
  {
    const std::int32_t c = column - left, r = row - top;
    return c < 0 || r < 0 || c >= width || r >= height ? unknown : *rowAt(row, c);
  }

  float&
  operator()(std::int32_t column, std::int32_t row)
  {
    return values[static_cast<std::size_t>(row - top) *
                      static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column - left)];
  }

  /** Bilinear between the middles of blocks; NaN where one of them is unknown. */
  float
  between(double column, double row) const
  {
    const double from_left = column - 0.5 - left, from_top = row - 0.5 - top;
    if (!(from_left >= 0 && from_top >= 0 && from_left < width - 1 &&
          from_top < height - 1))
      return unknown;
    const auto c = static_cast<std::int32_t>(from_left);
    const auto r = static_cast<std::int32_t>(from_top);
    const auto x = static_cast<float>(from_left - c);
    const auto y = static_cast<float>(from_top - r);
    const float* const above = rowAt(top + r, c);
    const float* const below = above + width;
    return (1 - y) * ((1 - x) * above[0] + x * above[1]) +
           y * ((1 - x) * below[0] + x * below[1]);
  }

private:
  /** \param[in] c columns from the left one */
  const float*
  rowAt(std::int32_t row, std::int32_t c) const
  {
    return &values[static_cast<std::size_t>(row - top) *
                       static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(c)];
  }
};

/** The same in blocks of twice the side; a block is known where two of its four are. */
BlockImage
halved(const BlockImage& fine);

} // namespace pcl::acmap::texturing
