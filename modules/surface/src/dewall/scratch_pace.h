#pragma once

#include "variant.h"

#include <pcl/core/impl/large_memory.h>

#include <cstddef>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Is called for each element of a loop over large arrays: from time to time, pages
 * that the loop brought into memory leave it. */
class ScratchPace {
public:
  void
  operator()()
  {
    if (visited_++ % 64 == 0)
      keepScratchSmall();
  }

private:
  std::size_t visited_ = 0;
};

} // namespace pcl::acmap::ACMAP_DEWALL
