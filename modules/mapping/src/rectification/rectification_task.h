#pragma once

#include <pcl/mapping/rectification_kernel.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Observations within this number share little drift: it defines "near" for the
 * rays, and the shortest window that is searched separately. */
inline constexpr std::size_t neighbours = 16;

/** \brief Inputs and outputs of a rectification. */
struct RectificationTask {
  const std::vector<LevelledPoints>& observations;
  const RectificationSettings& settings;
  const Progress& progress;
  EntropyRectificationReport& report;
};

} // namespace pcl::acmap
