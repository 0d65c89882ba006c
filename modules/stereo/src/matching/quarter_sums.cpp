#include "quarter_sums.h"

#include "../simd/cubic_weights.h"
#include "../simd/image_kernels.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr int lanes = 8;    ///< pixels that a kernel processes at once
constexpr int beside = 4;   ///< px beside a row that are summed, or read
constexpr int quarters = 4; ///< of a pixel

/** Rounds up to whole blocks. */
int
wholeLanes(int count)
{
  return (count + lanes - 1) / lanes * lanes;
}

/** Copies the levels from \a first to \a last, behind which the last one is repeated. */
void
copyLevels(const ShotStack& stack,
           int y,
           int first,
           int last,
           int length,
           std::vector<float>& levels)
{
  const ShotRows<std::int16_t> rows = stack.rows(y, first);
  levels.resize(static_cast<std::size_t>(rows.shots) *
                static_cast<std::size_t>(length));
  for (int k = 0; k < rows.shots; ++k) {
    float* const to = levels.data() + static_cast<std::int64_t>(k) * length;
    const std::int16_t* const from = rows.values + k * rows.plane;
    imageKernels().toFloats(from, last - first, to);
    std::fill(
        to + last - first, to + length, static_cast<float>(from[last - first - 1]));
  }
}

LevelSums
resizeSums(std::vector<float> (&sums)[4], int count, int before)
{
  for (std::vector<float>& one : sums)
    one.resize(static_cast<std::size_t>(count + 2 * before));
  return {sums[0].data() + before,
          sums[1].data() + before,
          sums[2].data() + before,
          sums[3].data() + before};
}

LevelSums
sumsFrom(const LevelSums& sums, int first)
{
  return {sums.squares + first,
          sums.values + first,
          sums.squares_of_five + first,
          sums.values_of_five + first};
}

} // namespace

void
QuarterSums::fill(const ShotStack& reference,
                  const ShotStack& target,
                  const PairWinners& winners,
                  const DisparityRange& range,
                  bool centred,
                  int y)
{
  width_ = reference.width();
  shots_ = reference.shots();
  findShifts(winners, range, y);
  copyLevels(reference, y, 0, width_, wholeLanes(width_), levels_);
  copyLevels(target,
             y,
             -beside,
             width_ + beside,
             wholeLanes(width_ + 2 * beside) + 2 * lanes,
             target_levels_);
  sumShots(!centred);
}

void
QuarterSums::findShifts(const PairWinners& winners, const DisparityRange& range, int y)
{
  constexpr int reach = 2;
  const auto size = static_cast<std::size_t>(width_);
  shifts_.assign(size + 2 * reach, MatchedRow::outside);
  least_.resize(size);
  greatest_.resize(size);
  const std::int16_t* const index =
      winners.index.data() + static_cast<std::int64_t>(y) * width_;
  int* const shifts = shifts_.data() + reach;
  for (int x = 0; x < width_; ++x) {
    const int shift = range.first + index[x];
    shifts[x] = x + shift < width_ ? shift : MatchedRow::outside;
  }
  for (int x = 0; x < width_; ++x) {
    const int* const at = shifts + x;
    least_[static_cast<std::size_t>(x)] =
        std::min({at[-2], at[-1], at[0], at[1], at[2]});
    greatest_[static_cast<std::size_t>(x)] =
        std::max({at[-2], at[-1], at[0], at[1], at[2]});
  }
  row_.shifts = shifts;
  row_.least = least_.data();
  row_.greatest = greatest_.data();
}

void
QuarterSums::sumShots(bool values)
{
  const PairKernels& kernels = pairKernels();
  const int stride = wholeLanes(width_);
  const int target_columns = wholeLanes(width_ + 2 * beside);
  const int target_stride = target_columns + 2 * lanes;
  const ShotRows<float> levels{levels_.data(), stride, shots_};
  const ShotRows<float> target_levels{
      target_levels_.data() + beside, target_stride, shots_};

  // Sums of products for a shift by 1 are read from behind those of the last pixel.
  constexpr int of_pixel = MatchedRow::products_of_pixel, reach = 2;
  const auto size = static_cast<std::size_t>((width_ + 2 * reach) * of_pixel);
  products_.resize(size);
  products_of_five_.resize(size);
  float* const products = products_.data() + reach * of_pixel;
  float* const products_of_five = products_of_five_.data() + reach * of_pixel;
  kernels.sumProducts(levels, target_levels, width_, row_.shifts, products);
  kernels.sumFive(products, width_ * of_pixel, of_pixel, products_of_five);
  row_.products = products;
  row_.products_of_five = products_of_five;

  const auto sumFive = [&](const LevelSums& of, int count, int step) {
    kernels.sumFive(of.squares, count, step, of.squares_of_five);
    if (values)
      kernels.sumFive(of.values, count, step, of.values_of_five);
  };
  row_.reference = resizeSums(sums_, stride, -MatchedRow::own_zeros);
  kernels.sumLevels(levels, stride, values, row_.reference);
  sumFive(row_.reference, stride, 1);
  row_.target =
      resizeSums(target_sums_, quarters * target_columns, -MatchedRow::target_zeros);
  const int before = beside - 1; // an interpolated level needs the one before it
  kernels.sumQuarters({target_levels.values - before, target_stride, shots_},
                      target_columns,
                      values,
                      sumsFrom(row_.target, -before * quarters));
  // Windows begin 1 px before a winner.
  sumFive(sumsFrom(row_.target, -quarters), quarters * target_columns, quarters);
}

float
QuarterSums::ownCorrelation(int x, int place, float floor) const
{
  const int pixel = place < 0 ? -1 : 0;
  const int quarter = place - quarters * pixel;
  const float* const sums = row_.products + MatchedRow::products_of_pixel * x +
                            MatchedRow::before + pixel - 1;
  float product = 0.0F;
  for (int tap = 0; tap < quarters; ++tap)
    product += cubic_weights[static_cast<std::size_t>(tap)]
                            [static_cast<std::size_t>(quarter)] *
               sums[tap];
  const float square = row_.target.squares[quarters * (x + row_.shifts[x]) + place];
  return product / std::sqrt((row_.reference.squares[x] + floor) * (square + floor));
}

} // namespace pcl::acmap
