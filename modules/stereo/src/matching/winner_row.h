#pragma once

#include "pair_costs.h"
#include "pair_winners.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The winners of one row for both views. */
class WinnerRow {
public:
  /** \brief Where a kernel stores the winners of row \a y. */
  RowWinners
  begin(int y, int width, int stride, PairWinners& winners);

  /** \brief Stores the winners of the neighbour's row. */
  void
  finish(int y, const DisparityRange& range, PairWinners& winners);

private:
  std::size_t width_ = 0;
  std::vector<std::int16_t> target_minimum_;
  std::vector<std::int16_t> target_pixel_;
};

} // namespace pcl::acmap
