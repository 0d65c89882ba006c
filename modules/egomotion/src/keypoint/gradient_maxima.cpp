#include "../image/smoothed_image.h"
#include "spread_choice.h"

#include <pcl/core/parallel.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** Squared gradient of the smoothed image by central differences; 0 along the border.
 */
GreyImage
squaredGradient(const GreyImage& image)
{
  const GreyImage smoothed = smoothedImage(image, 1);
  const int width = image.width;
  GreyImage gradient{width, image.height, std::vector<float>(image.values.size())};
  oneapi::tbb::parallel_for(1, std::max(image.height - 1, 1), [&](int y) {
    const float* const row = smoothed.values.data() + std::ptrdiff_t{y} * width;
    float* const out = gradient.values.data() + std::ptrdiff_t{y} * width;
    for (int x = 1; x + 1 < width; ++x) {
      const float right = (row[x + 1] - row[x - 1]) / 2;
      const float down = (row[x + width] - row[x - width]) / 2;
      out[x] = right * right + down * down;
    }
  });
  return gradient;
}

/** Marks the pixels of a row that are strict maxima. It has no branches, because the
 * comparisons are unpredictable. */
void
markMaxima(const float* row, int width, float least, std::uint8_t* is_maximum)
{
  const float *const above = row - width, *const below = row + width;
  for (int x = 2; x < width - 2; ++x) {
    const float value = row[x];
    is_maximum[x] = (value >= least) & (value > row[x - 1]) & (value > row[x + 1]) &
                    (value > above[x - 1]) & (value > above[x]) &
                    (value > above[x + 1]) & (value > below[x - 1]) &
                    (value > below[x]) & (value > below[x + 1]);
  }
}

/** Maxima of a row; only pixels whose neighbours all have a gradient are considered. */
std::vector<GradientMaximum>
maximaOfRow(const GreyImage& gradient, int y, float least)
{
  const int width = gradient.width;
  const float* const row = gradient.values.data() + std::ptrdiff_t{y} * width;
  std::vector<std::uint8_t> is_maximum(static_cast<std::size_t>(width));
  markMaxima(row, width, least, is_maximum.data());
  std::vector<GradientMaximum> maxima;
  for (int x = 0; x < width; ++x)
    if (is_maximum[static_cast<std::size_t>(x)])
      maxima.push_back({y * width + x, row[x]});
  return maxima;
}

std::vector<GradientMaximum>
maximaOf(const GreyImage& gradient, float least)
{
  std::vector<std::vector<GradientMaximum>> rows(
      static_cast<std::size_t>(gradient.height));
  oneapi::tbb::parallel_for(2, std::max(gradient.height - 2, 2), [&](int y) {
    rows[static_cast<std::size_t>(y)] = maximaOfRow(gradient, y, least);
  });
  std::vector<GradientMaximum> maxima;
  for (const std::vector<GradientMaximum>& row : rows)
    maxima.insert(maxima.end(), row.begin(), row.end());
  return maxima;
}

} // namespace

std::vector<std::int32_t>
gradientMaxima(const GreyImage& image,
               const std::vector<std::uint8_t>& has_place,
               const KeypointSettings& settings,
               KeypointCounts& counts)
{
  const float least = settings.min_gradient * settings.min_gradient;
  std::vector<GradientMaximum> maxima = withThreads(
      settings.threads, [&] { return maximaOf(squaredGradient(image), least); });
  counts.maxima = maxima.size();
  const auto has_none = [&](const GradientMaximum& maximum) {
    return !has_place[static_cast<std::size_t>(maximum.pixel)];
  };
  maxima.erase(std::remove_if(maxima.begin(), maxima.end(), has_none), maxima.end());
  counts.without_place = counts.maxima - maxima.size();
  counts.left_out = maxima.size() - std::min(maxima.size(), settings.most);
  return spreadChoice(std::move(maxima), image.width, settings);
}

} // namespace pcl::acmap
