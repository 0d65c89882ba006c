#pragma once

#include "voxels/chunked_array.h"

#include <pcl/core/impl/byte_parcel.h>
#include <pcl/core/impl/voxel_moments.h>

#include <algorithm>
#include <vector>

namespace pcl::acmap {

inline constexpr float way_steps = 16; // per edge

/** \brief The exact sums of a cell, in ticks of 2^-14 of an edge. */
struct CellSums {
  VoxelKey key = 0;
  std::int64_t first[3] = {};
  std::int64_t second[6] = {}; // xx xy xz yy yz zz
  std::int64_t way[3] = {};    // to the sensors, in 1/16 of an edge
  std::uint32_t count = 0;
  std::int32_t witness = 0;
  float squared_range = 0; ///< of the witness, in square metres

  /** \brief Adds a point by its offsets from the centre, whose products fit into 32
   * bits. */
  void
  add(std::int32_t x, std::int32_t y, std::int32_t z)
  {
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

  /** \brief Rounds a distance in 1/16 of an edge, limited so that no sum overflows. */
  static std::int32_t
  stepsOf(float way)
  {
    constexpr float largest = 1 << 24;
    const float above = way > -largest ? way : -largest; // NaN becomes -largest
    return static_cast<std::int32_t>(above < largest ? above : largest);
  }

  void
  offerWitness(std::int32_t index, float squared)
  {
    if (squared < squared_range || (squared == squared_range && index < witness)) {
      witness = index;
      squared_range = squared;
    }
  }

  void
  join(const CellSums& other);
};

/** \param[in] sums the sums of a cell
 * \param[in] edge of a voxel, metres */
VoxelCell
toVoxelCell(const CellSums& sums, double edge);

/** \brief The cells of some points, found by key in an open-addressing hash table. */
class CellTable {
public:
  /** \param[in] maximum expected number of cells, which may be exceeded */
  explicit CellTable(std::size_t maximum = 0);

  /** \brief Returns the index of the cell of a key; the cell is created if it does not
   * exist. */
  std::size_t
  find(VoxelKey key);

  /** \brief Adds cells of another table.
   * \param[in] other with colours, or without any, as all tables that are joined
   * \param[in] chosen indices of its cells */
  void
  join(const CellTable& other, const std::vector<std::uint32_t>& chosen);

  /** \brief Removes all cells, but keeps their memory. */
  void
  clear();

  ChunkedArray<CellSums> cells;
  ChunkedArray<ColorSum> colors; // parallel to the cells if there are colours

private:
  struct Slot {
    VoxelKey key;
    std::uint32_t cell;
  };

  void
  grow();

  void
  requestSlot(VoxelKey key) const;

  void
  requestCell(std::size_t cell) const;

  void
  joinCell(std::size_t own, const CellTable& other, std::size_t cell);

  std::vector<Slot, SystemAllocator<Slot>> slots_;
  int shift_ = 0;
};

/** \brief Puts the cells of a table into a parcel.
 * \param[in] first is added to the indices of points */
void
packCells(const CellTable& table, std::int32_t first, ByteParcel& parcel);

/** \brief Takes the cells of a table out of a parcel.
 * \throws IOException if it has fewer bytes */
CellTable
unpackedCells(ByteParcel& parcel);

} // namespace pcl::acmap
