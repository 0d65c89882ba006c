#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace pcl::acmap {

/** \brief Calls body (begin, end) for blocks of rows, in any order, in all threads of
 * the caller's arena. */
template <typename Body>
void
forRowBlocks(int height, const Body& body)
{
  constexpr int rows = 32;
  oneapi::tbb::parallel_for(0, (height + rows - 1) / rows, [&](int block) {
    body(block * rows, std::min((block + 1) * rows, height));
  });
}

} // namespace pcl::acmap
