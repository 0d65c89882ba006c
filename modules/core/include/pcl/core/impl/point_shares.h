#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/byte_parcel.h>
#include <pcl/core/impl/voxel_moments.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Parts of a cloud that other processes have, too, so that these can sum the
 * voxels of their points. The points of all parts follow each other. */
struct PointShares {
  /** \brief Number of the first points, which this process sums itself. */
  std::size_t own = 0;

  /** \brief Lets the others begin: request (lattice, has_sensors, has_colors). */
  std::function<void(const VoxelLattice&, bool, bool)> request;

  /** \brief Returns the next message of \ref sendCells, of one process after the other;
   * nothing after the last one. */
  std::function<std::optional<ByteParcel>()> receive;
};

/** \brief Sums the voxels of a part of a cloud for the process that has all of it.
 * \param[in] lattice of that process
 * \param[in] first index of the first point in the whole cloud
 * \param[in] send is called with each of several messages */
ACMAP_EXPORT void
sendCells(const PointView& points,
          const SensorView& sensors,
          const ColorView& colors,
          const VoxelLattice& lattice,
          std::int32_t first,
          unsigned threads,
          const std::function<void(ByteParcel)>& send);

} // namespace pcl::acmap
