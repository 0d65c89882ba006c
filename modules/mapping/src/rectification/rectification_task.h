#pragma once

#include <pcl/mapping/rectification_kernel.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Observations this close in time share little drift: what "near" is for the rays,
 * and the shortest window that is searched alone. */
inline constexpr std::size_t neighbours = 16;

/** \brief What a rectification works on. */
struct RectificationTask {
  const std::vector<LevelledPoints>& observations;
  const RectificationSettings& settings;
  const Progress& progress;
  EntropyRectificationReport& report;
};

} // namespace pcl::acmap
