#pragma once

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
  /** A plane's points. */
  struct Range {
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t*
    begin() const
    {
      return first;
    }

    const std::uint32_t*
    end() const
    {
      return last;
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
