#pragma once

#include <pcl/core/voxel_moments.h>

#include <algorithm>
#include <vector>

namespace pcl::acmap {

inline constexpr float way_steps = 16; // in an edge

/** \brief The exact sums of a cell, in ticks of 2^-14 of an edge. */
struct CellSums {
  VoxelKey key = 0;
  std::int64_t first[3] = {};
  std::int64_t second[6] = {}; // xx xy xz yy yz zz
  std::int64_t way[3] = {};    // to the sensors, in 1/16 of an edge
  std::uint32_t count = 0;
  std::int32_t witness = 0;
  float range = 0;

  void
  add(const VoxelHit& hit)
  {
    const std::int64_t x = hit.offset[0], y = hit.offset[1], z = hit.offset[2];
    ++count;
    first[0] += x;
    first[1] += y;
    first[2] += z;
    second[0] += x * x;
    second[1] += x * y;
    second[2] += x * z;
    second[3] += y * y;
    second[4] += y * z;
    second[5] += z * z;
  }

  /** \param[in] steps way from a point to its sensor, in 1/16 of an edge */
  void
  addWay(const Eigen::Vector3f& steps)
  {
    constexpr float largest = 1 << 24; // so many of them cannot overflow
    for (int axis = 0; axis < 3; ++axis)
      way[axis] +=
          static_cast<std::int32_t>(std::clamp(steps[axis], -largest, largest));
  }

  void
  offerWitness(std::int32_t index, float distance)
  {
    if (distance < range || (distance == range && index < witness)) {
      witness = index;
      range = distance;
    }
  }

  void
  join(const CellSums& other);
};

/** \param[in] edge of a voxel, metres */
VoxelCell
toVoxelCell(const CellSums& sums, double edge);

/** \brief The cells that some points fall into, found by key in an open-addressing
 * table. */
class CellTable {
public:
  CellTable();

  /** \brief Position of the key's cell, which is made where it was not yet. */
  std::size_t
  find(VoxelKey key);

  std::vector<CellSums> cells;
  std::vector<ColorSum> colors; // parallel to the cells where there are colours

private:
  void
  grow();

  struct Slot {
    VoxelKey key;
    std::uint32_t cell;
  };

  std::vector<Slot> slots_;
  int shift_ = 0;
};

} // namespace pcl::acmap
