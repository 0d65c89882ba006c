#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/voxel_moments.h>

#include <cstdlib>
#include <vector>

namespace pcl::acmap {

/** \brief A cell of a window and the offset of its voxel from the middle one. */
struct WindowPart {
  std::uint32_t cell;
  std::int8_t dx, dy, dz;

  /** \brief Is it in the inner 3 x 3 x 3 voxels? */
  bool
  isInner() const
  {
    return std::abs(dx) <= 1 && std::abs(dy) <= 1 && std::abs(dz) <= 1;
  }

  bool
  isMiddle() const
  {
    return dx == 0 && dy == 0 && dz == 0;
  }
};

/** \brief The occupied voxels of a cloud and the windows of voxels around them.
 * \ingroup core */
class ACMAP_EXPORT VoxelWindows {
public:
  /** \param[in] voxels must outlive this */
  explicit VoxelWindows(const VoxelMoments& voxels);

  /** \brief Number of occupied voxels, each with one cell or more. */
  std::size_t
  size() const
  {
    return begins_.size() - 1;
  }

  const VoxelMoments&
  voxels() const
  {
    return voxels_;
  }

  /** \brief Index of the first cell of a voxel; for voxel size() it is the number of
   * cells. */
  std::size_t
  firstCell(std::size_t voxel) const
  {
    return begins_[voxel];
  }

  /** \brief Collects the cells of the windows of ascending voxels in amortized constant
   * time. */
  class ACMAP_EXPORT Cursor {
  public:
    /** \param[in] windows the voxels
     * \param[in] reach of the windows: 1 for 3 x 3 x 3 voxels, 2 for 5 x 5 x 5 */
    Cursor(const VoxelWindows& windows, int reach);

    /** \param[in] voxel not smaller than at the last call
     * \return the cells of its window, in an order that only depends on their positions
     */
    const std::vector<WindowPart>&
    moveTo(std::size_t voxel);

  private:
    std::size_t
    firstCellFrom(VoxelKey key) const;

    const VoxelWindows& windows_;
    int reach_;
    // index of the next cell of each row of voxels along z
    std::vector<std::size_t> rows_;
    std::vector<WindowPart> parts_;
  };

private:
  const VoxelMoments& voxels_;
  LargeVector<std::size_t> begins_;
  LargeVector<VoxelKey> keys_; // of the cells, close to each other in memory
};

/** \brief Sums the parts selected by a predicate; the origin is the centre of the
 * middle voxel, the unit is the edge of a voxel. */
template <typename Choose>
Moments
sumParts(const VoxelMoments& voxels,
         const std::vector<WindowPart>& parts,
         const Choose& choose)
{
  Moments sum;
  for (const WindowPart& part : parts)
    if (choose(part))
      sum.addShifted(voxels.cells[part.cell].moments, part.dx, part.dy, part.dz);
  return sum;
}

} // namespace pcl::acmap
