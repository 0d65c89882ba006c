#pragma once

#include "variant.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief An edge of the mesh. */
struct Edge {
  static constexpr std::uint32_t largest_component = (1u << 29) - 1;

  std::int32_t high;      ///< its higher end; the edge is in the list of its lower end
  std::int32_t next;      ///< next edge in this list, -1 at the end
  std::int32_t opposites; ///< XOR of the third corners of its triangles
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

/** \brief Storage of edges that is filled by concurrent tasks; the index of an edge
 * does not change. */
class EdgePool {
public:
  explicit EdgePool(std::int32_t points)
  : blocks_(64 + static_cast<std::size_t>(points) / (block_size / 24))
  {}

  /** \brief Removes all edges. */
  void
  clear()
  {
    blocks_.clear();
    spare_.clear();
    taken_ = 0;
  }

  Edge&
  operator[](std::int32_t e)
  {
    return blocks_[static_cast<std::size_t>(e) / block_size]
                  [static_cast<std::size_t>(e) % block_size];
  }

  /** \brief Allocates new edges for one task, block by block. */
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
      for (const std::int32_t edge : given_back_)
        pool_->spare_.emplace_back(edge, edge + 1);
    }

    /** \brief Frees an edge that is no longer in a list. */
    void
    giveBack(std::int32_t edge)
    {
      given_back_.push_back(edge);
    }

    std::int32_t
    take()
    {
      if (!given_back_.empty()) {
        const std::int32_t edge = given_back_.back();
        given_back_.pop_back();
        return edge;
      }
      if (next_ == end_)
        std::tie(next_, end_) = pool_->takeRun();
      return next_++;
    }

  private:
    EdgePool* pool_;
    std::int32_t next_ = 0, end_ = 0;
    std::vector<std::int32_t> given_back_;
  };

private:
  static constexpr std::size_t block_size = 1024;

  /** \brief Returns the rest of a block of another task, or a new block. */
  std::pair<std::int32_t, std::int32_t>
  takeRun()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!spare_.empty()) {
      const auto run = spare_.back();
      spare_.pop_back();
      return run;
    }
    if (taken_ == blocks_.size())
      throw std::bad_alloc();
    blocks_[taken_] = std::make_unique<Edge[]>(block_size);
    const auto first = static_cast<std::int32_t>(taken_++ * block_size);
    return {first, first + static_cast<std::int32_t>(block_size)};
  }

  std::vector<std::unique_ptr<Edge[]>> blocks_;
  std::size_t taken_ = 0;
  std::vector<std::pair<std::int32_t, std::int32_t>> spare_; ///< runs of edges
  std::mutex mutex_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
