#include "light_pattern.h"

#include "gaussian_weights.h"

#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief Blurs an image along one direction; border values are repeated outside.
 * \param[in] lines number of lines, at a distance of line_step values
 * \param[in] length of a line, px, at a distance of step values */
struct LineBlur {
  std::size_t lines, line_step;
  std::size_t length, step;

  void
  run(std::vector<float>& values, const std::vector<float>& weights) const
  {
    const auto radius = static_cast<std::ptrdiff_t>(weights.size() / 2);
    const auto last = static_cast<std::ptrdiff_t>(length) - 1;
    std::vector<float> line(length);
    for (std::size_t i = 0; i < lines; ++i) {
      float* const at = &values[i * line_step];
      for (std::size_t j = 0; j < length; ++j)
        line[j] = at[j * step];
      for (std::ptrdiff_t j = 0; j <= last; ++j) {
        float sum = 0.0f;
        for (std::ptrdiff_t k = -radius; k <= radius; ++k)
          sum += weights[static_cast<std::size_t>(k + radius)] *
                 line[static_cast<std::size_t>(
                     std::clamp(j + k, std::ptrdiff_t{0}, last))];
        at[static_cast<std::size_t>(j) * step] = sum;
      }
    }
  }
};

} // namespace

LightPattern::LightPattern(const RgbImage& image, double blur)
: width_(image.width)
, height_(image.height)
{
  constexpr float finer = 257.0f; // factor from 255 to 65535
  const std::vector<float> weights = gaussianWeights(blur);
  const auto width = static_cast<std::size_t>(width_);
  const auto height = static_cast<std::size_t>(height_);
  values_.resize(image.values.size());
  std::vector<float> plane(width * height);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = finer * image.values[3 * i + channel];
    if (weights.size() > 1) {
      LineBlur{height, width, width, 1}.run(plane, weights);
      LineBlur{width, 1, height, width}.run(plane, weights);
    }
    for (std::size_t i = 0; i < plane.size(); ++i)
      values_[3 * i + channel] =
          static_cast<std::uint16_t>(std::clamp(plane[i] + 0.5f, 0.0f, 65535.0f));
  }
}

} // namespace pcl::acmap
