#include "window_sums.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

namespace pcl::acmap {

namespace {

struct ColumnSums {
  std::int64_t values = 0;
  std::int64_t squares = 0;
};

ColumnSums
sumColumn(const ShotStack& stack, int radius, int x, int y)
{
  ColumnSums sums;
  for (int row = y - radius; row <= y + radius; ++row) {
    const ShotRows<std::int16_t> shots = stack.rows(row, x);
    for (int k = 0; k < shots.shots; ++k) {
      const std::int64_t value = shots.values[k * shots.plane];
      sums.values += value;
      sums.squares += value * value;
    }
  }
  return sums;
}

} // namespace

WindowSums::WindowSums(const ShotStack& stack, const MatchingRecipe& recipe, int behind)
: stride_(stack.width() + behind)
, means_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stack.height()))
, inverse_norms_(means_.size())
{
  oneapi::tbb::parallel_for(
      0, stack.height(), [&](int y) { fillRow(stack, recipe, y); });
}

void
WindowSums::fillRow(const ShotStack& stack, const MatchingRecipe& recipe, int y)
{
  const int radius = recipe.radius, side = 2 * radius + 1;
  std::vector<ColumnSums> columns(static_cast<std::size_t>(stride_ + 2 * radius));
  for (int x = -radius; x < stride_ + radius; ++x)
    columns[static_cast<std::size_t>(x + radius)] = sumColumn(stack, radius, x, y);
  const double count = static_cast<double>(side) * side * stack.shots();
  const double floor = count * variance_floor * ShotStack::unit * ShotStack::unit;
  for (int x = 0; x < stride_; ++x) {
    ColumnSums sums;
    for (int i = 0; i < side; ++i) {
      sums.values += columns[static_cast<std::size_t>(x + i)].values;
      sums.squares += columns[static_cast<std::size_t>(x + i)].squares;
    }
    const double mean =
        recipe.centred ? 0.0 : static_cast<double>(sums.values) / std::sqrt(count);
    const double squares = static_cast<double>(sums.squares) - mean * mean + floor;
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) +
                    static_cast<std::size_t>(x);
    means_[at] = static_cast<float>(mean);
    inverse_norms_[at] = static_cast<float>(1.0 / std::sqrt(squares));
  }
}

} // namespace pcl::acmap
