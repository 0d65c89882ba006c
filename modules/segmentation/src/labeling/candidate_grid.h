#pragma once

#include "planes/known_planes.h"

#include <pcl/core/voxel_lattice.h>

#include <algorithm>
#include <array>

namespace pcl::acmap::labeling {

/** Planes near a place; at most so many, those of the voxel itself first. */
struct Candidates {
  static constexpr std::size_t most = 6;
  std::array<std::int32_t, most> planes;
  std::int32_t home = -1; ///< plane of a hypothesis in the voxel itself, -1 for none
  std::uint8_t size = 0;
  bool has_strangers = false;  ///< points of no plane in the voxel
  bool near_strangers = false; ///< or beside it

  void
  add(std::int32_t plane);

  bool
  holds(std::int32_t plane) const
  {
    return std::find(planes.begin(), planes.begin() + size, plane) !=
           planes.begin() + size;
  }
};

/** Which planes are within a voxel or two of any place: a hash table of voxels. */
class CandidateGrid {
public:
  /** \param[in] edge of a voxel, metres
   * \param[in] reach voxels around each hypothesis in which it is entered */
  CandidateGrid(const KnownPlanes& known, double edge, int reach);

  /** Follows planes that were joined or dropped.
   * \param[in] numbers for each plane its new number, -1 for none */
  void
  renumber(const std::vector<std::int32_t>& numbers);

  /** Number of the voxel's entry; -1 where no plane is near. */
  std::int32_t
  find(VoxelKey key) const;

  const Candidates&
  operator[](std::int32_t entry) const
  {
    return entries_[static_cast<std::size_t>(entry)];
  }

  const VoxelLattice&
  lattice() const
  {
    return lattice_;
  }

  /** Are there points of no plane at a place near a voxel? Noise moves points, so places
   * are asked for where rays meet planes: else the answer would sort points by their noise.
   */
  bool
  hasStrangersAt(const Eigen::Vector3d& place, std::int32_t near) const;

  /** Plane of a hypothesis in the voxel of a place, -1 for none. */
  std::int32_t
  homeAt(const Eigen::Vector3d& place) const;

  VoxelKey
  key(std::int32_t entry) const
  {
    return entry_keys_[static_cast<std::size_t>(entry)];
  }

  std::size_t
  size() const
  {
    return entries_.size();
  }

private:
  Candidates&
  entry(VoxelKey key);

  void
  grow();

  VoxelLattice lattice_;
  std::vector<VoxelKey> keys_;       ///< of the table's slots
  std::vector<std::int32_t> places_; ///< of the slots' entries, -1 for empty
  std::vector<Candidates> entries_;
  std::vector<VoxelKey> entry_keys_;
  std::size_t mask_ = 0;
};

} // namespace pcl::acmap::labeling
