#pragma once

#include "planes/known_planes.h"

#include <pcl/core/impl/voxel_lattice.h>
#include <pcl/core/scratch_memory.h>

#include <algorithm>
#include <array>

namespace pcl::acmap::labeling {

/** Planes near a voxel: at most \a maximum of them, those of the voxel itself first. */
struct Candidates {
  static constexpr std::size_t maximum = 6;
  std::array<std::int32_t, maximum> planes;
  std::int32_t home = -1; ///< plane of a hypothesis in the voxel itself, -1 for none
  std::uint8_t size = 0;
  bool has_strangers = false;  ///< the voxel contains points without a plane
  bool near_strangers = false; ///< the voxel or a neighbour contains such points

  void
  add(std::int32_t plane);

  bool
  holds(std::int32_t plane) const
  {
    return std::find(planes.begin(), planes.begin() + size, plane) !=
           planes.begin() + size;
  }
};

/** A hash table of voxels with the planes that are within a voxel or two of each. */
class CandidateGrid {
public:
  /** \param[in] edge edge length of a voxel, metres
   * \param[in] reach each hypothesis is entered in the voxels up to this distance from
   * its own
   * \param[in] is_entered for each point; empty: all are */
  CandidateGrid(const KnownPlanes& known,
                double edge,
                int reach,
                const std::vector<bool>& is_entered = {});

  /** Updates the numbers of planes after some were merged or removed.
   * \param[in] numbers for each plane its new number, -1 for none */
  void
  renumber(const std::vector<std::int32_t>& numbers);

  /** Returns the number of the entry of a voxel, -1 if no plane is near. */
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

  /** Does the voxel of a position near the voxel of the entry \a near contain points
   * without a plane? The position should be the intersection of a viewing ray with a
   * plane, not the measured point: noise moves points, so the result would depend on
   * the noise of each point. */
  bool
  hasStrangersAt(const Eigen::Vector3d& place, std::int32_t near) const
  {
    return (*this)[near].near_strangers && hasStrangersIn(place);
  }

  /** Returns the plane of a hypothesis in the voxel of a position, -1 for none. */
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
  bool
  hasStrangersIn(const Eigen::Vector3d& place) const;

  Candidates&
  entry(VoxelKey key);

  void
  grow();

  VoxelLattice lattice_;
  LargeVector<VoxelKey> keys_;       ///< keys of the table's slots
  LargeVector<std::int32_t> places_; ///< entry of each slot, -1 if empty
  LargeVector<Candidates> entries_;
  LargeVector<VoxelKey> entry_keys_;
  std::size_t mask_ = 0;
};

} // namespace pcl::acmap::labeling
