#include "texturing/canvas_painting.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::texturing {
namespace {

using Samples = std::array<Sample, Canvas::max_samples>;

struct Weighted {
  double value = 0, weight = 0;
};

using Weights = std::array<Weighted, Canvas::max_samples>;

double
weightedMedian(Weights& values, std::size_t count)
{
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
  // GCC 14 warns of a sort of so few, which it takes for 16 or more
  std::partial_sort(values.begin(), end, end, [](const Weighted& a, const Weighted& b) {
    return a.value < b.value;
  });
  double all = 0, sum = 0;
  for (auto one = values.begin(); one != end; ++one)
    all += one->weight;
  for (auto one = values.begin(); one != end; ++one) {
    sum += one->weight;
    if (2 * sum >= all)
      return one->value;
  }
  return values[count - 1].value;
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
  for (std::size_t k = 0; k < 3; ++k) {
    Weights values;
    std::size_t count = 0;
    for (const Sample& sample : samples)
      if (sample.weight > 0)
        values[count++] = {corrected(sample, k, gains), sample.weight};
    median[k] = weightedMedian(values, count);
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

namespace {

/** A texel, by column and row. */
using TexelAt = std::pair<std::int32_t, std::int32_t>;

/** Calls function (column, row) for a texel and its neighbours, as far as they are in the
 * picture. */
template <typename Function>
void
forAround(const RgbImage& picture, const TexelAt& texel, Function&& function)
{
  const auto& [column, row] = texel;
  for (std::int32_t r = std::max(row - 1, 0);
       r <= std::min(row + 1, picture.height - 1);
       ++r)
    for (std::int32_t c = std::max(column - 1, 0);
         c <= std::min(column + 1, picture.width - 1);
         ++c)
      function(c, r);
}

} // namespace

void
fillHoles(int distance, const LargeVector<TexelPlace>& mask, TexturePicture& picture)
{
  const auto texelAt = [&](std::int32_t column, std::int32_t row) {
    return static_cast<std::size_t>(row) *
               static_cast<std::size_t>(picture.colors.width) +
           static_cast<std::size_t>(column);
  };
  LargeVector<std::uint8_t> is_listed(mask.size(), 0);
  std::vector<TexelAt> next; // texels without a colour beside those with one
  const auto listAround = [&](const TexelAt& known) {
    forAround(picture.colors, known, [&](std::int32_t column, std::int32_t row) {
      const std::size_t texel = texelAt(column, row);
      if (mask[texel] == TexelPlace::Outside ||
          picture.kinds[texel] != TexelKind::None || is_listed[texel])
        return;
      is_listed[texel] = 1;
      next.emplace_back(column, row);
    });
  };
  for (std::int32_t row = 0; row < picture.colors.height; ++row)
    for (std::int32_t column = 0; column < picture.colors.width; ++column)
      if (picture.kinds[texelAt(column, row)] != TexelKind::None)
        listAround({column, row});
  for (int ring = 0; ring <= distance && !next.empty(); ++ring) {
    std::vector<TexelAt> filled;
    std::vector<std::array<std::uint8_t, 3>> colors;
    for (const auto& [column, row] : next) {
      std::array<std::uint8_t, 3> color{};
      const bool may_be =
          ring < distance || mask[texelAt(column, row)] == TexelPlace::Rim;
      if (may_be && meanOfNeighbours(picture, column, row, color)) {
        filled.emplace_back(column, row);
        colors.push_back(color);
      }
    }
    next.clear();
    for (std::size_t k = 0; k < filled.size(); ++k) {
      const auto& [column, row] = filled[k];
      std::copy(colors[k].begin(), colors[k].end(), picture.colors.at(column, row));
      picture.kinds[texelAt(column, row)] = TexelKind::Filled;
    }
    for (const TexelAt& texel : filled)
      listAround(texel);
  }
}

} // namespace pcl::acmap::texturing
