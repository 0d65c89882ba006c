#include "random_streams.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr unsigned index_bits = 12;
constexpr std::size_t table_size = std::size_t{1} << index_bits;
using Table = std::array<float, table_size>;

/** \brief Quantile of the normal distribution, by bisection. */
double
quantile(double share)
{
  double minimum = -9.0;
  double maximum = 9.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (minimum + maximum);
    (0.5 * std::erfc(-middle * std::sqrt(0.5)) < share ? minimum : maximum) = middle;
  }
  return 0.5 * (minimum + maximum);
}

Table
makeTable()
{
  std::array<double, table_size / 2> upper{};
  double squares = 0.0;
  for (std::size_t i = 0; i < upper.size(); ++i) {
    upper[i] = quantile(0.5 + (static_cast<double>(i) + 0.5) / table_size);
    squares += upper[i] * upper[i];
  }
  const double factor = std::sqrt(static_cast<double>(upper.size()) / squares);
  Table table{};
  for (std::size_t i = 0; i < upper.size(); ++i) {
    table[2 * i] = static_cast<float>(factor * upper[i]);
    table[2 * i + 1] = -table[2 * i];
  }
  return table;
}

} // namespace

void
fillNormal(std::uint64_t stream, float* to, std::size_t size)
{
  constexpr std::size_t numbers_of_draw = 64 / index_bits;
  static const Table table = makeTable();
  Random random(stream);
  for (std::size_t i = 0; i < size;) {
    std::uint64_t bits = random.bits();
    const std::size_t end = std::min(size, i + numbers_of_draw);
    for (; i < end; ++i, bits >>= index_bits)
      to[i] = table[bits % table_size];
  }
}

} // namespace pcl::acmap
