#include "texture_seams.h"

#include <cmath>

namespace pcl::acmap::bench {
namespace {

double
step(const TextureChart& chart, std::size_t a, std::size_t b)
{
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += chart.colors.values[3 * a + k] - chart.colors.values[3 * b + k];
  return std::abs(sum) / 3;
}

bool
isDeep(const texturing::Canvas& canvas, std::size_t texel, std::int32_t from_rim)
{
  const std::int32_t width = canvas.chart.colors.width;
  const auto column = static_cast<std::int32_t>(texel) % width;
  const auto row = static_cast<std::int32_t>(texel) / width;
  for (const std::int32_t way : {-from_rim, 0, from_rim})
    for (const std::int32_t aside : {-from_rim, 0, from_rim}) {
      const std::int32_t c = column + way, r = row + aside;
      if (c < 0 || r < 0 || c >= width || r >= canvas.chart.colors.height ||
          canvas.mask[canvas.index(c, r)] != texturing::TexelPlace::Inside)
        return false;
    }
  return true;
}

} // namespace

SeamSteps
measureSeams(const std::vector<texturing::Canvas>& canvases,
             const std::vector<TextureChart>& charts,
             std::int32_t from_rim)
{
  SeamSteps steps;
  std::size_t pairs = 0;
  for (std::size_t c = 0; c < canvases.size(); ++c) {
    const TextureChart& chart = charts[c];
    const auto width = static_cast<std::size_t>(chart.colors.width);
    for (std::size_t texel = 0; texel < chart.kinds.size(); ++texel)
      for (const std::size_t next : {texel + 1, texel + width}) {
        if (next >= chart.kinds.size() || (next == texel + 1 && next % width == 0) ||
            chart.kinds[texel] != TexelKind::Seen ||
            chart.kinds[next] != TexelKind::Seen ||
            !isDeep(canvases[c], texel, from_rim))
          continue;
        const bool is_border = canvases[c].samples[texel].front().view !=
                               canvases[c].samples[next].front().view;
        (is_border ? steps.across : steps.inside) += step(chart, texel, next);
        ++(is_border ? steps.borders : pairs);
      }
  }
  steps.across /= static_cast<double>(std::max<std::size_t>(steps.borders, 1));
  steps.inside /= static_cast<double>(std::max<std::size_t>(pairs, 1));
  return steps;
}

} // namespace pcl::acmap::bench
