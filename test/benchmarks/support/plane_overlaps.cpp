#include "plane_overlaps.h"

#include <algorithm>
#include <numeric>

namespace pcl::acmap::bench {

PlaneOverlaps::PlaneOverlaps(const std::vector<std::int32_t>& truth,
                             std::size_t truth_planes,
                             const std::vector<std::int32_t>& found,
                             std::size_t found_planes)
: truth_sizes_(truth_planes)
, found_sizes_(found_planes)
, common_(truth_planes * found_planes)
{
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto t = static_cast<std::size_t>(truth[i]);
    const auto f = static_cast<std::size_t>(found[i]);
    if (truth[i] >= 0)
      ++truth_sizes_[t];
    if (found[i] >= 0)
      ++found_sizes_[f];
    if (truth[i] >= 0 && found[i] >= 0)
      ++common_[f * truth_planes + t];
  }
}

std::size_t
PlaneOverlaps::labelledSize(std::size_t found) const
{
  const auto row = common_.begin() + static_cast<std::ptrdiff_t>(found * truths());
  return std::accumulate(
      row, row + static_cast<std::ptrdiff_t>(truths()), std::size_t{0});
}

std::int32_t
PlaneOverlaps::majority(std::size_t found) const
{
  if (labelledSize(found) == 0)
    return -1;
  const auto row = common_.begin() + static_cast<std::ptrdiff_t>(found * truths());
  const auto maximum =
      std::max_element(row, row + static_cast<std::ptrdiff_t>(truths()));
  return static_cast<std::int32_t>(maximum - row);
}

} // namespace pcl::acmap::bench
