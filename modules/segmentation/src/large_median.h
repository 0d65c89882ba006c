#pragma once

#include <pcl/core/impl/quantile.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::acmap {

/** Median of very many values. */
struct LargeMedian {
  std::size_t count = 0; ///< of values
  double value = 0;      ///< as \ref medianOf
};

/** Finds the median of values that are computed twice instead of being stored: first they
 * are counted by their leading bits, then those of one bin are sorted out.
 * \param[in] valueAt (i) for i below \a size, at the same time from several threads; not
 * negative, NaN for none */
template <typename ValueAt>
LargeMedian
largeMedianOf(std::size_t size, const ValueAt& valueAt)
{
  constexpr int dropped_bits = 49; // sign, exponent and three bits of the fraction stay
  constexpr std::size_t bins = std::size_t{1} << (64 - dropped_bits - 1);
  constexpr std::size_t max_parts = 64, min_part = 16384;
  const std::size_t part = std::max(min_part, (size + max_parts - 1) / max_parts);
  const std::size_t parts = (size + part - 1) / part;
  const auto forEachOf = [&](std::size_t p, const auto& visit) {
    for (std::size_t i = p * part; i < std::min((p + 1) * part, size); ++i) {
      const double value = valueAt(i);
      if (!(value >= 0))
        continue;
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      visit(value, static_cast<std::size_t>(bits >> dropped_bits) & (bins - 1));
    }
  };
  std::vector<std::vector<std::size_t>> counts(parts);
  oneapi::tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t p) {
    counts[p].assign(bins, 0);
    forEachOf(p, [&](double, std::size_t bin) { ++counts[p][bin]; });
  });
  std::vector<std::size_t> all(bins, 0);
  LargeMedian median;
  for (const std::vector<std::size_t>& of_part : counts)
    for (std::size_t bin = 0; bin < bins; ++bin) {
      all[bin] += of_part[bin];
      median.count += of_part[bin];
    }
  if (median.count == 0)
    return median;
  std::size_t middle = 0, rank = median.count / 2; // in its bin
  for (; rank >= all[middle]; ++middle)
    rank -= all[middle];
  std::vector<std::vector<double>> inside(parts);
  oneapi::tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t p) {
    inside[p].reserve(counts[p][middle]);
    forEachOf(p, [&](double value, std::size_t bin) {
      if (bin == middle)
        inside[p].push_back(value);
    });
  });
  std::vector<double> values;
  values.reserve(all[middle]);
  for (const std::vector<double>& some : inside)
    values.insert(values.end(), some.begin(), some.end());
  median.value = valueOfRank(values, rank);
  return median;
}

} // namespace pcl::acmap
