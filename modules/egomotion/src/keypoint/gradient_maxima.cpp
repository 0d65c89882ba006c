#include "../image/smoothed_image.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/egomotion/impl/keypoint_kernel.h>

#include <algorithm>
#include <functional>
#include <tuple>

namespace pcl::acmap {

namespace {

/** \brief A maximum of the gradient. */
struct GradientMaximum {
  std::int32_t pixel = 0;
  float squared_gradient = 0;
};

struct KeypointCandidate {
  std::int32_t turn = 0; ///< index of the cell, later the rank within the cell
  GradientMaximum maximum;

  bool
  operator<(const KeypointCandidate& other) const
  {
    return std::tuple(turn, -maximum.squared_gradient, maximum.pixel) <
           std::tuple(other.turn, -other.maximum.squared_gradient, other.maximum.pixel);
  }
};

std::vector<KeypointCandidate>
inTurns(const std::vector<GradientMaximum>& maxima,
        int width,
        const KeypointSettings& settings)
{
  const int cells = width / settings.cell_width + 1;
  std::vector<KeypointCandidate> candidates;
  for (const GradientMaximum& maximum : maxima) {
    const int column = maximum.pixel % width / settings.cell_width;
    const int row = maximum.pixel / width / settings.cell_height;
    candidates.push_back({row * cells + column, maximum});
  }
  std::sort(candidates.begin(), candidates.end());
  std::int32_t cell = -1, turn = 0;
  for (KeypointCandidate& candidate : candidates) {
    turn = candidate.turn == cell ? turn + 1 : 0;
    cell = candidate.turn;
    candidate.turn = turn;
  }
  return candidates;
}

/** Removes the maxima that are weak in comparison with the wanted number of strongest.
 */
void
dropWeak(std::vector<GradientMaximum>& maxima, std::size_t wanted)
{
  constexpr float min_share = 0.5F * 0.5F; // of the squared gradient
  std::vector<float> strengths;
  for (const GradientMaximum& maximum : maxima)
    strengths.push_back(maximum.squared_gradient);
  const auto last = strengths.begin() + static_cast<std::ptrdiff_t>(wanted - 1);
  std::nth_element(strengths.begin(), last, strengths.end(), std::greater<>());
  const float minimum = min_share * *last;
  const auto is_weak = [&](const GradientMaximum& maximum) {
    return maximum.squared_gradient < minimum;
  };
  maxima.erase(std::remove_if(maxima.begin(), maxima.end(), is_weak), maxima.end());
}

/** \brief Selects the maximum number of keypoints, see \ref gradientMaxima; in the last
 * turn, the strongest ones.
 * \return pixels in ascending order */
std::vector<std::int32_t>
spreadChoice(std::vector<GradientMaximum> maxima,
             int width,
             const KeypointSettings& settings)
{
  std::vector<std::int32_t> pixels;
  if (maxima.size() <= settings.maximum) {
    for (const GradientMaximum& maximum : maxima)
      pixels.push_back(maximum.pixel);
    return pixels;
  }
  dropWeak(maxima, settings.maximum);
  std::vector<KeypointCandidate> candidates = inTurns(maxima, width, settings);
  const auto end = candidates.begin() + static_cast<std::ptrdiff_t>(settings.maximum);
  std::nth_element(candidates.begin(), end, candidates.end());
  for (std::size_t k = 0; k < settings.maximum; ++k)
    pixels.push_back(candidates[k].maximum.pixel);
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

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
markMaxima(const float* row, int width, float minimum, std::uint8_t* is_maximum)
{
  const float *const above = row - width, *const below = row + width;
  for (int x = 2; x < width - 2; ++x) {
    const float value = row[x];
    is_maximum[x] = (value >= minimum) & (value > row[x - 1]) & (value > row[x + 1]) &
                    (value > above[x - 1]) & (value > above[x]) &
                    (value > above[x + 1]) & (value > below[x - 1]) &
                    (value > below[x]) & (value > below[x + 1]);
  }
}

/** Maxima of a row; only pixels whose neighbours all have a gradient are considered. */
std::vector<GradientMaximum>
maximaOfRow(const GreyImage& gradient, int y, float minimum)
{
  const int width = gradient.width;
  const float* const row = gradient.values.data() + std::ptrdiff_t{y} * width;
  std::vector<std::uint8_t> is_maximum(static_cast<std::size_t>(width));
  markMaxima(row, width, minimum, is_maximum.data());
  std::vector<GradientMaximum> maxima;
  for (int x = 0; x < width; ++x)
    if (is_maximum[static_cast<std::size_t>(x)])
      maxima.push_back({y * width + x, row[x]});
  return maxima;
}

std::vector<GradientMaximum>
maximaOf(const GreyImage& gradient, float minimum)
{
  std::vector<std::vector<GradientMaximum>> rows(
      static_cast<std::size_t>(gradient.height));
  oneapi::tbb::parallel_for(2, std::max(gradient.height - 2, 2), [&](int y) {
    rows[static_cast<std::size_t>(y)] = maximaOfRow(gradient, y, minimum);
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
  const float minimum = settings.min_gradient * settings.min_gradient;
  std::vector<GradientMaximum> maxima = withThreads(
      settings.threads, [&] { return maximaOf(squaredGradient(image), minimum); });
  counts.maxima = maxima.size();
  const auto has_none = [&](const GradientMaximum& maximum) {
    return !has_place[static_cast<std::size_t>(maximum.pixel)];
  };
  maxima.erase(std::remove_if(maxima.begin(), maxima.end(), has_none), maxima.end());
  counts.without_place = counts.maxima - maxima.size();
  counts.left_out = maxima.size() - std::min(maxima.size(), settings.maximum);
  return spreadChoice(std::move(maxima), image.width, settings);
}

} // namespace pcl::acmap
