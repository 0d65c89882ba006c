#include "census.h"

#include <oneapi/tbb/parallel_for.h>

#include <array>

namespace pcl::acmap {

namespace {

/** Parameters of one word. */
struct CensusWord {
  int difference;       ///< in 16ths of a grey level
  int reach_x, reach_y; ///< px
};

constexpr std::array<CensusWord, Census::words> census_words{
    {{-12, 2, 2}, {-5, 4, 3}, {5, 4, 3}, {12, 2, 2}}};

/** Fills a row, neighbour by neighbour, so that adjacent pixels can be vectorized. */
void
fillRow(
    const ShotStack& shot, const CensusWord& word, int y, int size, std::uint64_t* bits)
{
  const std::int16_t* const middle = shot.rows(y).values;
  for (int row = -word.reach_y; row <= word.reach_y; ++row)
    for (int column = -word.reach_x; column <= word.reach_x; ++column) {
      if (row == 0 && column == 0)
        continue;
      const std::int16_t* const other = shot.rows(y + row, column).values;
      for (int x = 0; x < size; ++x)
        bits[x] = (bits[x] << 1) | (other[x] > middle[x] + word.difference ? 1U : 0U);
    }
}

} // namespace

Census::Census(const ShotStack& shot, int behind)
: stride_(shot.width() + behind)
, plane_(static_cast<std::int64_t>(stride_) * shot.height())
, bits_(static_cast<std::size_t>(plane_ * words))
{
  oneapi::tbb::parallel_for(0, shot.height(), [&](int y) {
    std::uint64_t* out = bits_.data() + static_cast<std::int64_t>(y) * stride_;
    for (const CensusWord& word : census_words) {
      fillRow(shot, word, y, stride_, out);
      out += plane_;
    }
  });
}

} // namespace pcl::acmap
