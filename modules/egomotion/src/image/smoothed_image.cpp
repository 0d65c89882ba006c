#include "smoothed_image.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** Half of a Gaussian, from the middle on; the sum over both halves is 1. */
std::vector<float>
halfGaussian(float sigma)
{
  std::vector<float> weights(static_cast<std::size_t>(std::ceil(3 * sigma)) + 1);
  float sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const float distance = static_cast<float>(k) / sigma;
    weights[k] = std::exp(-distance * distance / 2);
    sum += (k ? 2 : 1) * weights[k];
  }
  for (float& weight : weights)
    weight /= sum;
  return weights;
}

/** Smooths one row, first along the columns and then along the row. */
class RowSmoother {
public:
  RowSmoother(const GreyImage& image, const std::vector<float>& weights)
  : image_(image)
  , weights_(weights)
  , rim_(static_cast<int>(weights.size()) - 1)
  , column_(static_cast<std::size_t>(image.width + 2 * rim_))
  {}

  void
  smooth(int y, float* out)
  {
    smoothColumns(y);
    const float* const middle = column_.data() + rim_;
    for (int x = 0; x < image_.width; ++x)
      out[x] = weights_[0] * middle[x];
    for (int k = 1; k <= rim_; ++k) {
      const float weight = weights_[static_cast<std::size_t>(k)];
      for (int x = 0; x < image_.width; ++x)
        out[x] += weight * (middle[x - k] + middle[x + k]);
    }
  }

private:
  const float*
  rowOf(int y) const
  {
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, image_.height - 1));
    return image_.values.data() + row * static_cast<std::size_t>(image_.width);
  }

  void
  smoothColumns(int y)
  {
    float* const middle = column_.data() + rim_;
    const float* const row = rowOf(y);
    for (int x = 0; x < image_.width; ++x)
      middle[x] = weights_[0] * row[x];
    for (int k = 1; k <= rim_; ++k) {
      const float weight = weights_[static_cast<std::size_t>(k)];
      const float *const above = rowOf(y - k), *const below = rowOf(y + k);
      for (int x = 0; x < image_.width; ++x)
        middle[x] += weight * (above[x] + below[x]);
    }
    std::fill(middle - rim_, middle, middle[0]);
    std::fill_n(middle + image_.width, rim_, middle[image_.width - 1]);
  }

  const GreyImage& image_;
  const std::vector<float>& weights_;
  int rim_;
  std::vector<float> column_;
};

} // namespace

GreyImage
smoothedImage(const GreyImage& image, float sigma)
{
  GreyImage smoothed{
      image.width, image.height, std::vector<float>(image.values.size())};
  if (image.values.empty())
    return smoothed;
  const std::vector<float> weights = halfGaussian(sigma);
  using Rows = oneapi::tbb::blocked_range<int>;
  oneapi::tbb::parallel_for(Rows(0, image.height, 16), [&](const Rows& rows) {
    RowSmoother smoother(image, weights);
    for (int y = rows.begin(); y != rows.end(); ++y)
      smoother.smooth(y, smoothed.values.data() + std::ptrdiff_t{y} * image.width);
  });
  return smoothed;
}

} // namespace pcl::acmap
