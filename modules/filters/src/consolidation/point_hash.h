#pragma once

#include <pcl/core/impl/parallel.h>
#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <cstdint>

namespace pcl::acmap {

/** \brief Hash grid of points with cells of twice a radius, so that a ball of that
 * radius overlaps at most eight of them. Different cells may share a slot, so the
 * caller must check distances. The points of a slot are next to each other in memory,
 * and so are those of the cells of a block. */
class PointHash {
public:
  struct Entry {
    Eigen::Vector3f point;
    std::uint32_t name;
  };

  /** \param[in] entries the points; they are not kept
   * \param[in] radius metres */
  PointHash(const LargeVector<Entry>& entries, float radius)
  : cell_(2 * radius)
  {
    std::size_t size = 16;
    while (size < entries.size())
      size *= 2;
    mask_ = size - 1;
    LargeVector<std::uint32_t> slots(entries.size());
    parallelForChunks(entries.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        slots[i] = static_cast<std::uint32_t>(
            slotOf((entries[i].point.array() / cell_).floor()));
    });
    begins_.assign(size + 1, 0);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      keepSmall(i);
      ++begins_[slots[i] + 1];
    }
    for (std::size_t slot = 0; slot < size; ++slot)
      begins_[slot + 1] += begins_[slot];
    entries_.resize(entries.size());
    for (std::size_t i = entries.size(); i-- > 0;) {
      keepSmall(i);
      entries_[--begins_[slots[i] + 1]] = entries[i];
    }
    // each begin is now in the slot after its own
    begins_.erase(begins_.begin());
    begins_.push_back(static_cast<std::uint32_t>(entries.size()));
  }

  /** \brief Calls visit (entry) for the points in the cells around a position; a point
   * may be visited twice because of hash collisions. */
  template <typename Visit>
  void
  visitNear(const Eigen::Vector3f& point, const Visit& visit) const
  {
    const Eigen::Array3f cells = point.array() / cell_;
    const Eigen::Array3f middle = cells.floor();
    const Eigen::Array3f nearer =
        (cells - middle < 0.5f).select(middle - 1, middle + 1);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Array3f cell(corner & 1 ? nearer[0] : middle[0],
                                corner & 2 ? nearer[1] : middle[1],
                                corner & 4 ? nearer[2] : middle[2]);
      const std::size_t slot = slotOf(cell);
      for (std::size_t i = begins_[slot]; i < begins_[slot + 1]; ++i)
        visit(entries_[i]);
    }
  }

private:
  static void
  keepSmall(std::size_t i)
  {
    if (i % parallel_chunk == 0)
      pollRun();
  }

  /** The cells of a block have slots side by side: what is near is near in memory. */
  std::size_t
  slotOf(const Eigen::Array3f& cell) const
  {
    constexpr int bits = 3; // of an axis within a block
    std::uint64_t block = 0, place = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<std::int64_t>(cell[axis]);
      block = (block + static_cast<std::uint64_t>(along >> bits)) * 0x9e3779b97f4a7c15u;
      place = place << bits | (static_cast<std::uint64_t>(along) & ((1 << bits) - 1));
    }
    // In another order for each block: a wall has an eighth of the places of its blocks.
    place ^= block >> 20 & ((1 << 3 * bits) - 1);
    return static_cast<std::size_t>((block >> 32) << 3 * bits | place) & mask_;
  }

  float cell_; // metres
  std::size_t mask_ = 0;
  LargeVector<std::uint32_t> begins_; // of the slots, and the end of the last one
  LargeVector<Entry> entries_;
};

} // namespace pcl::acmap
