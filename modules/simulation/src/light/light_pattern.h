#pragma once

#include <pcl/core/image_file.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A pattern after the projector's lens, interpolated linearly between its
 * pixels. */
class LightPattern {
public:
  /** \param[in] image at least 2 px in both directions
   * \param[in] blur standard deviation, px */
  LightPattern(const RgbImage& image, double blur);

  /** \brief Red, green, blue, each in [0, 1].
   * \param[in] u, v px, within the image */
  std::array<float, 3>
  at(float u, float v) const
  {
    constexpr float unit = 1.0f / 65535.0f;
    const int column = std::min(static_cast<int>(u), width_ - 2);
    const int row = std::min(static_cast<int>(v), height_ - 2);
    const float s = u - static_cast<float>(column);
    const float t = v - static_cast<float>(row);
    const std::size_t stride = 3 * static_cast<std::size_t>(width_);
    const std::uint16_t* const upper = &values_[static_cast<std::size_t>(row) * stride +
                                                3 * static_cast<std::size_t>(column)];
    const std::uint16_t* const lower = upper + stride;
    const float a = unit * (1.0f - s) * (1.0f - t);
    const float b = unit * s * (1.0f - t);
    const float c = unit * (1.0f - s) * t;
    const float d = unit * s * t;
    std::array<float, 3> color;
    for (int i = 0; i < 3; ++i)
      color[static_cast<std::size_t>(i)] =
          a * upper[i] + b * upper[i + 3] + c * lower[i] + d * lower[i + 3];
    return color;
  }

private:
  int width_;
  int height_;
  std::vector<std::uint16_t> values_; // red, green, blue; 65535 is full light
};

} // namespace pcl::acmap
