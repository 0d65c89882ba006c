#pragma once

#include "variant.h"

#include <pcl/core/progress.h>

#include <cstddef>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Is called for each element of a loop over large arrays, and polls the run from time
 * to time. */
class PollPace {
public:
  void
  operator()()
  {
    if (visited_++ % 64 == 0)
      pollRun();
  }

private:
  std::size_t visited_ = 0;
};

} // namespace pcl::acmap::ACMAP_DEWALL
