#pragma once

#include "voxels/cell_sums.h"

#include <mutex>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief The cells of all points, to which several threads add at the same time: each
 * part has the cells with a range of the keys. Their sums do not depend on the order in
 * which they were added. */
class SharedCells {
public:
  /** \param[in] limits ascending, between the keys of the parts */
  explicit SharedCells(std::vector<VoxelKey> limits)
  : limits_(std::move(limits))
  , parts_(limits_.size() + 1)
  {}

  void
  join(const CellTable& cells);

  /** \brief The table of the only part, if there are no limits and one thread. */
  CellTable&
  only()
  {
    return parts_.front().table;
  }

  std::size_t
  parts() const
  {
    return parts_.size();
  }

  /** \brief Takes the cells of a part away. */
  CellTable
  take(std::size_t part)
  {
    return std::exchange(parts_[part].table, CellTable());
  }

  /** \brief Moves the cells to an object without any, in ascending order of their
   * keys. The parts are released one after the other, as both together are large. */
  void
  moveTo(VoxelMoments& voxels);

private:
  struct Part {
    std::mutex mutex;
    CellTable table;
  };

  std::vector<VoxelKey> limits_;
  std::vector<Part> parts_;
};

} // namespace pcl::acmap
