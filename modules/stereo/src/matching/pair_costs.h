#pragma once

#include "recipe.h"
#include "shot_stack.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Disparities that are searched for: first, first + 1, ... */
struct DisparityRange {
  int first = 0; ///< px
  int count = 0;

  /** \brief Count, filled up to whole blocks. */
  int
  stride() const
  {
    return (count + disparity_block - 1) / disparity_block * disparity_block;
  }
};

/** \brief A number for each pixel and disparity. */
struct CostVolume {
  int width = 0;
  int height = 0;
  int stride = 0;
  std::vector<std::int16_t> values;

  void
  resize(int new_width, int new_height, int new_stride);

  const std::int16_t*
  at(int x, int y) const
  {
    return values.data() + (static_cast<std::int64_t>(y) * width + x) * stride;
  }

  CostRow
  row(int y)
  {
    return {
        values.data() + static_cast<std::int64_t>(y) * width * stride, width, stride};
  }
};

/** \brief What it costs to give a pixel a disparity; both stacks centred as the recipe has
 * it, the target with the range's first + stride behind its rows. Runs in all threads of
 * the caller's arena. */
void
fillCosts(const ShotStack& reference,
          const ShotStack& target,
          const MatchingRecipe& recipe,
          const DisparityRange& range,
          CostVolume& costs);

} // namespace pcl::acmap
