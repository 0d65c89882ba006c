#include "labeling/plane_members.h"

#include <pcl/core/impl/large_memory.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::acmap::labeling {

PlaneMembers::PlaneMembers(const std::int32_t* labels,
                           std::size_t size,
                           std::size_t planes)
: first_(planes + 1, 0)
, largest_first_(planes)
{
  constexpr std::size_t max_parts = 64, min_part = 16384;
  const std::size_t part = std::max(min_part, (size + max_parts - 1) / max_parts);
  std::vector<std::vector<std::size_t>> places((size + part - 1) / part);
  const auto forEachIn = [&](std::size_t p, const auto& visit) {
    const std::size_t end = std::min((p + 1) * part, size);
    for (std::size_t i = p * part; i < end; ++i)
      if (labels[i] >= 0)
        visit(i, places[p][static_cast<std::size_t>(labels[i])]);
  };
  oneapi::tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t p) {
    places[p].assign(planes, 0);
    forEachIn(p, [](std::size_t, std::size_t& count) { ++count; });
  });
  std::size_t place = 0;
  for (std::size_t plane = 0; plane < planes; ++plane) {
    first_[plane] = place;
    for (std::vector<std::size_t>& of_part : places)
      place += std::exchange(of_part[plane], place);
  }
  first_[planes] = place;
  assignLarge(members_, place, std::uint32_t{0});
  oneapi::tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t p) {
    forEachIn(p, [&](std::size_t i, std::size_t& next) {
      members_[next++] = static_cast<std::uint32_t>(i);
    });
  });
  std::iota(largest_first_.begin(), largest_first_.end(), std::size_t{0});
  const auto members = [&](std::size_t plane) {
    return first_[plane + 1] - first_[plane];
  };
  std::stable_sort(
      largest_first_.begin(), largest_first_.end(), [&](std::size_t a, std::size_t b) {
        return members(a) > members(b);
      });
}

} // namespace pcl::acmap::labeling
