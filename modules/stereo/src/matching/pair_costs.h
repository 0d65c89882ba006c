#pragma once

#include "disparity_volume.h"
#include "recipe.h"
#include "shot_stack.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Disparities of the search range: first, first + 1, ... */
struct DisparityRange {
  int first = 0; ///< px
  int count = 0;

  /** \brief Count, rounded up to whole blocks. */
  int
  stride(int block = disparity_block) const
  {
    return (count + block - 1) / block * block;
  }
};

/** \brief One cost per pixel and disparity. */
using CostVolume = DisparityVolume<std::int16_t, CostRow>;

/** \brief Computes the cost of each disparity of each pixel from windows or the census;
 * for costs over time, see \ref fillTimeCosts. Both stacks must be
 * centred if the recipe is; the target must be readable for first + stride pixels
 * behind its rows. Runs in all threads of the caller's arena. */
void
fillCosts(const ShotStack& reference,
          const ShotStack& target,
          const MatchingRecipe& recipe,
          const DisparityRange& range,
          CostVolume& costs);

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
