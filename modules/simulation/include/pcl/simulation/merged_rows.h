#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/simulation/simulated_observation.h>

#include <cstddef>
#include <cstdint>

namespace pcl {

/** \brief Merges observations to one cloud in files, if there is a ScratchMemory: a building
 * has more points than the memory has room for. The points are those of
 * \ref mergeObservations. \ingroup simulation */
class ACMAP_EXPORT MergedRows {
public:
  /** \param[in] trajectory T_map_camera of all views */
  explicit MergedRows(const Trajectory& trajectory);

  /** \brief Appends the finite points of an observation.
   * \param[in] view index of its pose
   * \throws BadArgumentException if there is no such pose */
  void
  append(const SimulatedObservation& observation, std::size_t view);

  /** \brief All points: x y z rgb view label. Nothing can be appended afterwards. */
  CloudRows
  finish();

private:
  MergedObservations part_; ///< of one view
  LargeVector<std::uint8_t> rows_;
};

} // namespace pcl
