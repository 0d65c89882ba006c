#pragma once

#include <pcl/core/progress.h>
#include <pcl/core/scratch_memory.h>

#include <oneapi/tbb/parallel_for.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::labeling {

/** The points of each plane, in the order of the points. Sums over one plane do not
 * need the points of others, so that planes are summed at the same time, with the same
 * result for any number of threads. */
class PlaneMembers {
public:
  /** Passes over a plane's points. What belongs to them may be far apart in scratch
   * memory, and each visit may bring in pages. */
  class Iterator {
  public:
    explicit Iterator(const std::uint32_t* member)
    : member_(member)
    {}

    std::uint32_t
    operator*() const
    {
      return *member_;
    }

    Iterator&
    operator++()
    {
      constexpr std::uintptr_t bytes = 4096; // of members: 1024 of them
      if (reinterpret_cast<std::uintptr_t>(++member_) % bytes == 0)
        pollRun();
      return *this;
    }

    bool
    operator!=(const Iterator& other) const
    {
      return member_ != other.member_;
    }

  private:
    const std::uint32_t* member_;
  };

  /** A plane's points. */
  struct Range {
    const std::uint32_t* first;
    const std::uint32_t* last;

    Iterator
    begin() const
    {
      return Iterator(first);
    }

    Iterator
    end() const
    {
      return Iterator(last);
    }
  };

  /** \param[in] labels plane of each point, -1 for none */
  PlaneMembers(const std::int32_t* labels, std::size_t size, std::size_t planes);

  /** Calls visit (plane, members) for each plane. */
  template <typename Visit>
  void
  forEachPlane(const Visit& visit) const
  {
    oneapi::tbb::parallel_for(
        std::size_t{0}, largest_first_.size(), [&](std::size_t k) {
          const std::size_t plane = largest_first_[k];
          visit(plane,
                Range{members_.data() + first_[plane],
                      members_.data() + first_[plane + 1]});
        });
  }

private:
  std::vector<std::size_t> first_; ///< first member of each plane, and their number
  LargeVector<std::uint32_t> members_;
  std::vector<std::size_t> largest_first_; ///< planes
};

} // namespace pcl::acmap::labeling
