#pragma once

#include <pcl/core/impl/voxel_windows.h>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief Sums over the two windows around a voxel, in edges relative to its centre. */
struct WindowSum {
  Moments inner; ///< of 3 x 3 x 3 voxels
  Moments whole; ///< of 5 x 5 x 5 voxels

  /** \brief Are the sums exact? Then they are those of any other order of adding. */
  bool
  isExact() const
  {
    // moments are multiples of 2^-30, and at most 2.5^2 per point: below 2^53 of these
    constexpr double max_count = 1 << 20;
    return whole.count <= max_count;
  }
};

/** \brief The sums over the windows around all voxels.
 *
 * Windows along a row of the lattice overlap: a plane of 5 x 5 voxels across the row is
 * summed once for the five windows that contain it. */
class WindowSums {
public:
  /** \param[in] windows must outlive this */
  explicit WindowSums(const VoxelWindows& windows);

  /** \brief Sums the windows of ascending voxels in amortized constant time. */
  class Cursor {
  public:
    explicit Cursor(const WindowSums& sums);

    /** \param[in] voxel not smaller than at the last call */
    WindowSum
    moveTo(std::size_t voxel);

  private:
    WindowSum
    sumPlane(std::int32_t z);

    const WindowSums& sums_;
    std::array<std::size_t, 25> rows_{}; // next voxel of each row of the window
    std::array<WindowSum, 8> planes_;    // by the last bits of their z
    VoxelPlace place_{-1, -1, -1};       // of the last voxel
    std::int32_t next_plane_ = 0;        // z of the next plane to be summed
  };

private:
  std::vector<VoxelKey> keys_;
  UnfilledArray<Moments> moments_; // of the voxels, over all their cells
};

} // namespace pcl::acmap
