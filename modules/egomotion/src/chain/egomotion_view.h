#pragma once

#include "chain/appearance_level.h"
#include "chain/feature_level.h"
#include "chain/pinhole.h"
#include "chain/surface_blocks.h"

#include <pcl/egomotion/egomotion_kernel.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

struct EgomotionView {
  std::size_t points = 0;         ///< with a place
  std::size_t unknown_sigmas = 0; ///< of these, in a view that knows others
  std::optional<Pinhole> pinhole;
  std::vector<FeatureLevel> features; ///< fine to coarse
  SurfaceBlocks surfaces;
  std::vector<AppearanceLevel> appearance; ///< empty without refinement

  std::size_t
  keypoints() const
  {
    std::size_t count = 0;
    for (const FeatureLevel& level : features)
      count += level.pixels.size();
    return count;
  }
};

} // namespace pcl::acmap
