#include "winner_row.h"

namespace pcl::acmap {

RowWinners
WinnerRow::begin(int y, int width, int stride, PairWinners& winners)
{
  width_ = static_cast<std::size_t>(width);
  target_minimum_.assign(width_ + static_cast<std::size_t>(stride), 32767);
  target_pixel_.assign(target_minimum_.size(), -1);
  return {&winners.index[static_cast<std::size_t>(y) * width_],
          target_minimum_.data(),
          target_pixel_.data()};
}

void
WinnerRow::finish(int y, const DisparityRange& range, PairWinners& winners)
{
  const std::size_t begin = static_cast<std::size_t>(y) * width_;
  for (std::size_t x = 0; x < width_; ++x) {
    const bool is_seen = x >= static_cast<std::size_t>(range.first);
    winners.matched_by[begin + x] =
        is_seen ? target_pixel_[x - static_cast<std::size_t>(range.first)]
                : std::int16_t{-1};
  }
}

} // namespace pcl::acmap
