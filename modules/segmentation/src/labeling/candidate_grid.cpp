#include "labeling/candidate_grid.h"

#include <algorithm>

namespace pcl::acmap::labeling {
namespace {

std::size_t
slotOf(VoxelKey key, std::size_t mask)
{
  const VoxelKey mixed = (key >> octant_bits) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(mixed >> 20) & mask;
}

/** All pairs of a voxel and a label in it, sorted, without duplicates. */
LargeVector<std::pair<VoxelKey, std::int32_t>>
labeledVoxels(const KnownPlanes& known,
              const VoxelLattice& lattice,
              const std::vector<bool>& is_entered)
{
  LargeVector<std::pair<VoxelKey, std::int32_t>> voxels;
  VoxelHit hit;
  for (std::size_t i = 0; i < known.labels.size(); ++i)
    if ((is_entered.empty() || is_entered[i]) && lattice.locate(known.points[i], hit))
      voxels.emplace_back(voxelKey(hit.place), known.labels[i]);
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

} // namespace

void
Candidates::add(std::int32_t plane)
{
  const auto end = planes.begin() + size;
  if (size < maximum && std::find(planes.begin(), end, plane) == end)
    planes[size++] = plane;
}

CandidateGrid::CandidateGrid(const KnownPlanes& known,
                             double edge,
                             int reach,
                             const std::vector<bool>& is_entered)
: lattice_(known.points, edge)
{
  const auto voxels = labeledVoxels(known, lattice_, is_entered);
  std::size_t slots = 1024; // each voxel of a plane has about two around it
  while (reach > 0 && slots < 8 * voxels.size())
    slots *= 2;
  keys_.resize(slots);
  places_.resize(slots, -1);
  mask_ = slots - 1;
  for (const auto& [key, label] : voxels) {
    Candidates& own = entry(key);
    own.has_strangers |= label < 0;
    if (label < 0)
      continue;
    own.add(label);
    if (own.home < 0)
      own.home = label;
  }
  for (const auto& [key, label] : voxels) {
    const VoxelPlace place = placeOf(key);
    for (std::int32_t dx = -reach; dx <= reach; ++dx)
      for (std::int32_t dy = -reach; dy <= reach; ++dy)
        for (std::int32_t dz = -reach; dz <= reach; ++dz) {
          Candidates& near =
              entry(voxelKey({place[0] + dx, place[1] + dy, place[2] + dz}));
          if (label < 0)
            near.near_strangers = true;
          else
            near.add(label);
        }
  }
}

void
CandidateGrid::renumber(const std::vector<std::int32_t>& numbers)
{
  for (Candidates& candidates : entries_) {
    const Candidates before = candidates;
    candidates.size = 0;
    for (std::size_t k = 0; k < before.size; ++k) {
      const std::int32_t number = numbers[static_cast<std::size_t>(before.planes[k])];
      if (number < 0)
        candidates.near_strangers = true;
      else
        candidates.add(number);
    }
    if (before.home >= 0)
      candidates.home = numbers[static_cast<std::size_t>(before.home)];
    candidates.has_strangers |= before.home >= 0 && candidates.home < 0;
  }
}

bool
CandidateGrid::hasStrangersIn(const Eigen::Vector3d& place) const
{
  VoxelHit hit;
  if (!lattice_.locate(place.cast<float>(), hit))
    return false;
  const std::int32_t there = find(voxelKey(hit.place));
  return there >= 0 && (*this)[there].has_strangers;
}

std::int32_t
CandidateGrid::homeAt(const Eigen::Vector3d& place) const
{
  VoxelHit hit;
  const std::int32_t there =
      lattice_.locate(place.cast<float>(), hit) ? find(voxelKey(hit.place)) : -1;
  return there < 0 ? -1 : (*this)[there].home;
}

std::int32_t
CandidateGrid::find(VoxelKey key) const
{
  std::size_t slot = slotOf(key, mask_);
  while (places_[slot] >= 0 && keys_[slot] != key)
    slot = (slot + 1) & mask_;
  return places_[slot];
}

Candidates&
CandidateGrid::entry(VoxelKey key)
{
  std::size_t slot = slotOf(key, mask_);
  for (; places_[slot] >= 0; slot = (slot + 1) & mask_)
    if (keys_[slot] == key)
      return entries_[static_cast<std::size_t>(places_[slot])];
  keys_[slot] = key;
  places_[slot] = static_cast<std::int32_t>(entries_.size());
  entries_.emplace_back();
  entry_keys_.push_back(key);
  if (2 * entries_.size() > mask_)
    grow();
  return entries_.back();
}

void
CandidateGrid::grow()
{
  LargeVector<VoxelKey> keys(2 * keys_.size());
  LargeVector<std::int32_t> places(2 * keys_.size(), -1);
  const std::size_t mask = keys.size() - 1;
  for (std::size_t old = 0; old < keys_.size(); ++old) {
    if (places_[old] < 0)
      continue;
    std::size_t slot = slotOf(keys_[old], mask);
    while (places[slot] >= 0)
      slot = (slot + 1) & mask;
    keys[slot] = keys_[old];
    places[slot] = places_[old];
  }
  keys_ = std::move(keys);
  places_ = std::move(places);
  mask_ = mask;
}

} // namespace pcl::acmap::labeling
