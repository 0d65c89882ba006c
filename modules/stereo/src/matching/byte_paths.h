#pragma once

#include "time_costs.h"
#include "winner_row.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief As \ref PathSums, for costs in bytes and constant penalties. Instead of a sum
 * along eight paths, it keeps what this sum exceeds eight times the cost by: a byte. */
class BytePaths {
public:
  /** \param[in] uniqueness if true, the uniqueness is computed */
  void
  findWinners(const DisparityRange& range,
              const BytePenalties& penalties,
              bool uniqueness,
              ByteVolume& costs,
              PairWinners& winners);

private:
  class Pass;

  std::vector<std::uint8_t> excess_;
  WinnerRow winner_row_;
};

} // namespace pcl::acmap
