#pragma once

#include "variant.h"

#include <pcl/core/impl/large_memory.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <list>
#include <mutex>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A triangle of tree points. */
struct GrownTriangle {
  std::array<std::int32_t, 3> corners;
  std::int32_t component; ///< the seed it grew from, which has the same orientation

  /** \brief Is it removed, but still in its list? */
  bool
  isTakenOut() const
  {
    return component < 0;
  }
};

class TriangleStore;

/** \brief Allocates from a store if there is one, otherwise from the heap. */
template <typename Value>
struct StoredAllocator {
  using value_type = Value;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  StoredAllocator() = default;

  explicit StoredAllocator(TriangleStore& s)
  : store(&s)
  {}

  template <typename Other>
  StoredAllocator(const StoredAllocator<Other>& other)
  : store(other.store)
  {}

  Value*
  allocate(std::size_t count);

  void
  deallocate(Value* memory, std::size_t count)
  {
    if (!store) // it keeps all it gave
      std::allocator<Value>().deallocate(memory, count);
  }

  bool
  operator==(const StoredAllocator& other) const
  {
    return store == other.store;
  }

  bool
  operator!=(const StoredAllocator& other) const
  {
    return store != other.store;
  }

  TriangleStore* store = nullptr;
};

using GrownTriangles = std::vector<GrownTriangle, StoredAllocator<GrownTriangle>>;

/** \brief The triangles of all finished parts in few large arrays, which can be in files:
 * those of a single part are too small for one. */
class TriangleStore {
public:
  explicit TriangleStore(std::int32_t points)
  : run_size_(
        std::clamp<std::size_t>(static_cast<std::size_t>(points) / 4, min_run, max_run))
  {}

  TriangleStore(const TriangleStore&) = delete;
  TriangleStore&
  operator=(const TriangleStore&) = delete;

  /** \brief A copy in the store. */
  GrownTriangles
  copyOf(const GrownTriangles& triangles)
  {
    return GrownTriangles(
        triangles.begin(), triangles.end(), StoredAllocator<GrownTriangle>(*this));
  }

  GrownTriangle*
  take(std::size_t count)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (runs_.empty() || runs_.back().size() - used_ < count) {
      runs_.emplace_back();
      runs_.back().resize(std::max(count, run_size_));
      used_ = 0;
    }
    GrownTriangle* const first = runs_.back().data() + used_;
    used_ += count;
    return first;
  }

private:
  static constexpr std::size_t min_run = 1 << 10, max_run = 1 << 20;

  const std::size_t run_size_;
  std::list<UnfilledArray<GrownTriangle>> runs_;
  std::size_t used_ = 0; ///< triangles of the last run
  std::mutex mutex_;
};

template <typename Value>
Value*
StoredAllocator<Value>::allocate(std::size_t count)
{
  return store ? store->take(count) : std::allocator<Value>().allocate(count);
}

} // namespace pcl::acmap::ACMAP_DEWALL
