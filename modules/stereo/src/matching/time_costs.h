#pragma once

#include "../simd/byte_kernels.h"
#include "disparity_volume.h"
#include "pair_costs.h"
#include "shot_stack.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief One byte per pixel and disparity. */
using ByteVolume = DisparityVolume<std::uint8_t, ByteRow>;

/** \brief Computes the cost of each disparity of each pixel from its grey levels over
 * time; as \ref fillCosts, with a stride of whole byte blocks. Both stacks must be
 * centred. */
void
fillTimeCosts(const ShotStack& reference,
              const ShotStack& target,
              const DisparityRange& range,
              ByteVolume& costs);

} // namespace pcl::acmap
