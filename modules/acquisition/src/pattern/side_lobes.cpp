#include "side_lobes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {
namespace {

constexpr double main_lobe_end = 0.5;
constexpr double gated_share = 0.99;
constexpr std::int32_t max_lines_measured = 256;

/** \brief Cumulative sums of values and of their squares. */
struct RunningSums {
  std::vector<std::int64_t> first = {0};
  std::vector<std::int64_t> second = {0};

  explicit RunningSums(const std::vector<int>& values)
  {
    for (const std::int64_t value : values) {
      first.push_back(first.back() + value);
      second.push_back(second.back() + value * value);
    }
  }

  /** n^2 times the variance of n values. */
  double
  scatter(std::size_t from, std::size_t to) const
  {
    const std::int64_t sum = first[to] - first[from];
    return static_cast<double>(
        static_cast<std::int64_t>(to - from) * (second[to] - second[from]) - sum * sum);
  }
};

std::int64_t
productSum(const std::vector<int>& values, std::size_t shift)
{
  // sums of 32 bits can hold 1,024 products of values up to 3 * 255
  constexpr std::size_t block = 1024;
  const std::size_t size = values.size() - shift;
  std::int64_t sum = 0;
  for (std::size_t begin = 0; begin < size; begin += block) {
    const std::size_t end = std::min(size, begin + block);
    std::int32_t part = 0;
    for (std::size_t i = begin; i < end; ++i)
      part += values[i] * values[i + shift];
    sum += part;
  }
  return sum;
}

/** \brief Correlation coefficient of a row with its shifted copy; 1 if one of the
 * overlapping parts has no contrast, since a match is then ambiguous. */
double
selfCorrelation(const std::vector<int>& values,
                const RunningSums& sums,
                std::size_t shift)
{
  const std::size_t size = values.size() - shift;
  const double scatters =
      std::sqrt(sums.scatter(0, size)) * std::sqrt(sums.scatter(shift, values.size()));
  if (scatters == 0)
    return 1;
  const std::int64_t products =
      static_cast<std::int64_t>(size) * productSum(values, shift) -
      sums.first[size] * (sums.first[values.size()] - sums.first[shift]);
  return static_cast<double>(products) / scatters;
}

template <typename ValueAt>
SideLobes
lobesOf(std::int32_t lines, std::int32_t length, int range, const ValueAt& valueAt)
{
  const std::int32_t measured = std::min(lines, max_lines_measured);
  std::vector<double> lobes;
  std::vector<int> values(static_cast<std::size_t>(length));
  for (std::int32_t i = 0; i < measured; ++i) {
    const std::int32_t line = static_cast<std::int32_t>(
        (2 * std::int64_t{i} + 1) * lines / (2 * std::int64_t{measured}));
    for (std::int32_t k = 0; k < length; ++k) {
      const std::uint8_t* const color = valueAt(line, k);
      values[static_cast<std::size_t>(k)] = color[0] + color[1] + color[2];
    }
    lobes.push_back(sideLobeOf(values, range));
  }
  std::sort(lobes.begin(), lobes.end());
  const auto gated =
      static_cast<std::size_t>(gated_share * static_cast<double>(lobes.size() - 1));
  return {lobes[gated], lobes.back()};
}

} // namespace

double
sideLobeOf(const std::vector<int>& values, int range)
{
  const RunningSums sums(values);
  const std::size_t maximum =
      std::min(static_cast<std::size_t>(range), values.size() / 2);
  double before = 1;
  double highest = 0;
  bool fallen = false;
  bool ended = false;
  for (std::size_t shift = 1; shift <= maximum; ++shift) {
    const double correlation = selfCorrelation(values, sums, shift);
    ended = ended || (fallen && correlation > before);
    if (ended)
      highest = std::max(highest, correlation);
    fallen = fallen || correlation < main_lobe_end;
    before = correlation;
  }
  return fallen ? std::min(highest, 1.0) : 1.0;
}

SideLobes
rowSideLobes(const RgbImage& image, int range)
{
  return lobesOf(image.height,
                 image.width,
                 range,
                 [&](std::int32_t row, std::int32_t k) { return image.at(k, row); });
}

SideLobes
columnSideLobes(const RgbImage& image, int range)
{
  return lobesOf(
      image.width, image.height, range, [&](std::int32_t column, std::int32_t k) {
        return image.at(column, k);
      });
}

} // namespace pcl::acmap
