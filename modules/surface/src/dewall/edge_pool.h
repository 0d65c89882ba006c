#pragma once

#include "lanes.h"

#include <pcl/core/impl/large_memory.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief An edge of the mesh. It is stored at its lower end. */
struct Edge {
  static constexpr std::uint32_t largest_component = (1u << 29) - 1;

  std::int32_t opposites;       ///< XOR of the third corners of its triangles
  std::uint32_t component : 29; ///< component of its first triangle
  std::uint32_t ascending : 1;  ///< its first triangle runs from lower to higher end
  std::uint32_t triangles : 2;  ///< their number, at most 2

  std::int32_t
  componentNumber() const
  {
    return static_cast<std::int32_t>(component);
  }

  void
  setComponent(std::int32_t number)
  {
    component = static_cast<std::uint32_t>(number) & largest_component;
  }

  bool
  isOpen() const
  {
    return triangles == 1;
  }
};

/** \brief Up to four edges with the same lower end. Their higher ends are side by side,
 * so that one comparison finds an edge. */
struct EdgeBlock {
  static constexpr int capacity = 4;
  static constexpr std::int32_t empty = -1;

  std::int32_t high[capacity] = {empty, empty, empty, empty};
  Edge edges[capacity];

  /** \brief Returns the edge to a higher end, nullptr if it is not in this block. */
  Edge*
  find(std::int32_t end)
  {
    const unsigned places = bitsOfEqual(high, end);
    return places ? &edges[lowestBit(places)] : nullptr;
  }
};

/** \brief The fifth and further edges of a vertex. */
struct MoreEdges {
  EdgeBlock block;
  std::int32_t next = -1; ///< where the list continues, -1 at its end
};

/** \brief Storage of the edges beyond the first four of each vertex. It is filled by
 * concurrent tasks; the index of an entry does not change. */
class EdgePool {
public:
  explicit EdgePool(std::int32_t points)
  : runs_(64 + static_cast<std::size_t>(points) / (run_size / 6))
  , runs_in_block_(std::clamp<std::size_t>(
        static_cast<std::size_t>(points) / points_a_run, 1, max_runs_in_block))
  {}

  /** \brief Removes all entries. */
  void
  clear()
  {
    runs_.clear();
    blocks_.clear();
    spare_.clear();
    taken_ = 0;
  }

  MoreEdges&
  operator[](std::int32_t e)
  {
    return runs_[static_cast<std::size_t>(e) / run_size]
                [static_cast<std::size_t>(e) % run_size];
  }

  /** \brief Allocates new entries for one task, run by run. */
  class Cursor {
  public:
    explicit Cursor(EdgePool& pool)
    : pool_(&pool)
    {}

    Cursor(const Cursor&) = delete;
    Cursor&
    operator=(const Cursor&) = delete;

    ~Cursor()
    {
      const std::lock_guard<std::mutex> lock(pool_->mutex_);
      if (next_ != end_)
        pool_->spare_.emplace_back(next_, end_);
      for (const std::int32_t entry : given_back_)
        pool_->spare_.emplace_back(entry, entry + 1);
    }

    /** \brief Frees an entry that is no longer in a list. */
    void
    giveBack(std::int32_t entry)
    {
      given_back_.push_back(entry);
    }

    /** \brief Returns an entry without edges. */
    std::int32_t
    take()
    {
      const std::int32_t entry = takeAny();
      (*pool_)[entry] = {};
      return entry;
    }

  private:
    std::int32_t
    takeAny()
    {
      if (!given_back_.empty()) {
        const std::int32_t entry = given_back_.back();
        given_back_.pop_back();
        return entry;
      }
      if (next_ == end_)
        std::tie(next_, end_) = pool_->takeRun();
      return next_++;
    }

    EdgePool* pool_;
    std::int32_t next_ = 0, end_ = 0;
    std::vector<std::int32_t> given_back_;
  };

private:
  static constexpr std::size_t run_size = 1024;
  static constexpr std::size_t max_runs_in_block = 128; ///< 7 MB
  static constexpr std::size_t points_a_run = 16384;

  /** \brief Returns the rest of a run of another task, or a new run. */
  std::pair<std::int32_t, std::int32_t>
  takeRun()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!spare_.empty()) {
      const auto run = spare_.back();
      spare_.pop_back();
      return run;
    }
    if (taken_ == runs_.size())
      throw std::bad_alloc();
    if (taken_ % runs_in_block_ == 0) {
      blocks_.emplace_back();
      blocks_.back().resize(runs_in_block_ * run_size);
    }
    runs_[taken_] = blocks_.back().data() + taken_ % runs_in_block_ * run_size;
    const auto first = static_cast<std::int32_t>(taken_++ * run_size);
    return {first, first + static_cast<std::int32_t>(run_size)};
  }

  std::vector<MoreEdges*> runs_;
  /** Entries that are set when they are taken. The runs are parts of a few large arrays,
   * which can be in files. */
  std::vector<UnfilledArray<MoreEdges>> blocks_;
  const std::size_t runs_in_block_;
  std::size_t taken_ = 0;
  std::vector<std::pair<std::int32_t, std::int32_t>> spare_;
  std::mutex mutex_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
