#pragma once

#include "../simd/byte_kernels.h"
#include "pair_costs.h"
#include "shot_stack.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief One byte per pixel and disparity. */
struct ByteVolume {
  int width = 0;
  int height = 0;
  int stride = 0;
  std::vector<std::uint8_t> values;

  void
  resize(int new_width, int new_height, int new_stride);

  const std::uint8_t*
  at(int x, int y) const
  {
    return values.data() + (static_cast<std::int64_t>(y) * width + x) * stride;
  }

  ByteRow
  row(int y)
  {
    return {
        values.data() + static_cast<std::int64_t>(y) * width * stride, width, stride};
  }
};

/** \brief Computes the cost of each disparity of each pixel from its grey levels over
 * time; as \ref fillCosts, with a stride of whole byte blocks. Both stacks must be
 * centred. */
void
fillTimeCosts(const ShotStack& reference,
              const ShotStack& target,
              const DisparityRange& range,
              ByteVolume& costs);

} // namespace pcl::acmap
