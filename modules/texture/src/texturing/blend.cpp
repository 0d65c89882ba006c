#include "texturing/canvas_painting.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::texturing {
namespace {

using Samples = std::array<Sample, Canvas::max_samples>;

struct Weighted {
  double value, weight;
};

double
weightedMedian(std::vector<Weighted>& values)
{
  std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) {
    return a.value < b.value;
  });
  double all = 0, sum = 0;
  for (const Weighted& one : values)
    all += one.weight;
  for (const Weighted& one : values) {
    sum += one.weight;
    if (2 * sum >= all)
      return one.value;
  }
  return values.back().value;
}

double
corrected(const Sample& sample, std::size_t channel, const std::vector<double>& gains)
{
  return sample.color[channel] * gains[static_cast<std::size_t>(sample.view)];
}

std::array<double, 3>
medianOf(const Samples& samples, const std::vector<double>& gains)
{
  std::array<double, 3> median{};
  std::vector<Weighted> values;
  for (std::size_t k = 0; k < 3; ++k) {
    values.clear();
    for (const Sample& sample : samples)
      if (sample.weight > 0)
        values.push_back({corrected(sample, k, gains), sample.weight});
    median[k] = weightedMedian(values);
  }
  return median;
}

std::array<std::uint8_t, 3>
blendedColor(const Samples& samples, const std::vector<double>& gains)
{
  constexpr double max_off = 30; // maximum deviation in any channel, of 255
  const std::array<double, 3> median = medianOf(samples, gains);
  std::array<double, 3> sums{};
  double weights = 0;
  for (const Sample& sample : samples) {
    bool agrees = sample.weight > 0;
    for (std::size_t k = 0; k < 3 && agrees; ++k)
      agrees = std::abs(corrected(sample, k, gains) - median[k]) <= max_off;
    if (!agrees)
      continue;
    const double weight = std::sqrt(sample.weight);
    weights += weight;
    for (std::size_t k = 0; k < 3; ++k)
      sums[k] += weight * corrected(sample, k, gains);
  }
  std::array<std::uint8_t, 3> color{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = weights > 0 ? sums[k] / weights : median[k];
    color[k] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  }
  return color;
}

void
clear(TexturePicture& picture, std::size_t texels)
{
  picture.colors.values.assign(3 * texels, unknown_grey);
  picture.kinds.assign(texels, TexelKind::None);
}

void
setSeen(const std::array<std::uint8_t, 3>& color,
        std::size_t texel,
        TexturePicture& picture)
{
  std::copy(color.begin(), color.end(), &picture.colors.values[3 * texel]);
  picture.kinds[texel] = TexelKind::Seen;
}

/** Mean colour of the known texels among the eight neighbours. \return false if there
 * are none */
bool
meanOfNeighbours(const TexturePicture& picture,
                 std::int32_t column,
                 std::int32_t row,
                 std::array<std::uint8_t, 3>& color)
{
  std::array<int, 3> sums{};
  int count = 0;
  for (std::int32_t r = std::max(row - 1, 0);
       r <= std::min(row + 1, picture.colors.height - 1);
       ++r)
    for (std::int32_t c = std::max(column - 1, 0);
         c <= std::min(column + 1, picture.colors.width - 1);
         ++c) {
      const auto texel =
          static_cast<std::size_t>(r) * static_cast<std::size_t>(picture.colors.width) +
          static_cast<std::size_t>(c);
      if (picture.kinds[texel] == TexelKind::None)
        continue;
      ++count;
      for (std::size_t k = 0; k < 3; ++k)
        sums[k] += picture.colors.at(c, r)[k];
    }
  for (std::size_t k = 0; k < 3 && count > 0; ++k)
    color[k] = static_cast<std::uint8_t>((sums[k] + count / 2) / count);
  return count > 0;
}

} // namespace

void
blend(const std::vector<double>& gains, const Canvas& canvas, TexturePicture& picture)
{
  clear(picture, canvas.mask.size());
  for (std::size_t texel = 0; texel < canvas.mask.size(); ++texel)
    if (canvas.samples[texel].front().weight > 0)
      setSeen(blendedColor(canvas.samples[texel], gains), texel, picture);
}

void
average(const Canvas& canvas, TexturePicture& picture)
{
  clear(picture, canvas.mask.size());
  for (std::size_t texel = 0; texel < canvas.mask.size(); ++texel)
    if (canvas.points[texel].count > 0)
      setSeen(canvas.points[texel].mean(), texel, picture);
}

void
fillHoles(int distance, const LargeVector<TexelPlace>& mask, TexturePicture& picture)
{
  const auto texelAt = [&](std::int32_t column, std::int32_t row) {
    return static_cast<std::size_t>(row) *
               static_cast<std::size_t>(picture.colors.width) +
           static_cast<std::size_t>(column);
  };
  std::vector<std::pair<std::int32_t, std::int32_t>> holes;
  for (std::int32_t row = 0; row < picture.colors.height; ++row)
    for (std::int32_t column = 0; column < picture.colors.width; ++column) {
      const std::size_t texel = texelAt(column, row);
      if (mask[texel] != TexelPlace::Outside && picture.kinds[texel] == TexelKind::None)
        holes.emplace_back(column, row);
    }
  for (int ring = 0; ring <= distance && !holes.empty(); ++ring) {
    const bool is_last = ring == distance;
    std::vector<std::pair<std::int32_t, std::int32_t>> left, filled;
    std::vector<std::array<std::uint8_t, 3>> colors;
    for (const auto& [column, row] : holes) {
      std::array<std::uint8_t, 3> color{};
      const bool may_be = !is_last || mask[texelAt(column, row)] == TexelPlace::Rim;
      if (may_be && meanOfNeighbours(picture, column, row, color)) {
        filled.emplace_back(column, row);
        colors.push_back(color);
      }
      else
        left.emplace_back(column, row);
    }
    if (filled.empty())
      break;
    for (std::size_t k = 0; k < filled.size(); ++k) {
      const auto& [column, row] = filled[k];
      std::copy(colors[k].begin(), colors[k].end(), picture.colors.at(column, row));
      picture.kinds[texelAt(column, row)] = TexelKind::Filled;
    }
    holes = std::move(left);
  }
}

} // namespace pcl::acmap::texturing
