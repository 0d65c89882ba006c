#include "quarter_sums.h"

#include <array>

namespace pcl::acmap {

namespace {

constexpr int quarters = 4;
constexpr int before = 2; ///< px to the left of a winner

/** Weights at each quarter, of the pixel before a position, the pixel itself and the
 * two behind it: cubic convolution (Keys, 1981). */
constexpr std::array<std::array<float, quarters>, 4> weights{
    {{0.0F, -0.0703125F, -0.0625F, -0.0234375F},
     {1.0F, 0.8671875F, 0.5625F, 0.2265625F},
     {0.0F, 0.2265625F, 0.5625F, 0.8671875F},
     {0.0F, -0.0234375F, -0.0625F, -0.0703125F}}};

} // namespace

void
QuarterSums::interpolate(const ShotStack& target, int y, int length)
{
  const ShotRows<std::int16_t> rows = target.rows(y, -before);
  quarters_.resize(static_cast<std::size_t>(length) * quarters *
                   static_cast<std::size_t>(rows.shots));
  float* out = quarters_.data();
  for (int k = 0; k < rows.shots; ++k)
    for (int x = 0; x < length; ++x) {
      const std::int16_t* const at = rows.values + k * rows.plane + x;
      const float levels[] = {static_cast<float>(at[-1]),
                              static_cast<float>(at[0]),
                              static_cast<float>(at[1]),
                              static_cast<float>(at[2])};
      for (std::size_t quarter = 0; quarter < quarters; ++quarter)
        out[quarter] =
            weights[0][quarter] * levels[0] + weights[1][quarter] * levels[1] +
            weights[2][quarter] * levels[2] + weights[3][quarter] * levels[3];
      out += quarters;
    }
}

void
QuarterSums::fill(const ShotStack& reference,
                  const ShotStack& target,
                  const PairWinners& winners,
                  const DisparityRange& range,
                  int y)
{
  const int width = reference.width();
  // A winner at the border of the image may need two pixels beyond it.
  const int length = width + 2 * before;
  interpolate(target, y, length);
  const ShotRows<std::int16_t> rows = reference.rows(y);
  const auto size = static_cast<std::size_t>(width);
  levels_.resize(size * static_cast<std::size_t>(rows.shots));
  squares_.assign(size, 0.0F);
  values_.assign(size, 0.0F);
  for (int k = 0; k < rows.shots; ++k) {
    const std::int16_t* const from = rows.values + k * rows.plane;
    float* const levels = levels_.data() + static_cast<std::int64_t>(k) * width;
    for (std::size_t x = 0; x < size; ++x) {
      levels[x] = from[x];
      squares_[x] += levels[x] * levels[x];
      values_[x] += levels[x];
    }
  }

  const std::int16_t* const index =
      winners.index.data() + static_cast<std::int64_t>(y) * width;
  sums_.resize(size);
  winners_.resize(size);
  for (int x = 0; x < width; ++x) {
    const auto at = static_cast<std::size_t>(x);
    const int column = x + range.first + index[x];
    winners_[at] = column < width ? index[x] : outside;
    if (column < width)
      pairKernels().sumAtQuarters(
          {levels_.data() + x, width, rows.shots},
          {quarters_.data() + column * quarters, length * quarters, rows.shots},
          sums_[at]);
  }
}

} // namespace pcl::acmap
