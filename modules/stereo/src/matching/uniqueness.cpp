#include "uniqueness.h"

#include <cstdlib>
#include <limits>

namespace pcl::acmap {

std::uint8_t
uniquenessOf(const std::vector<int>& sums, int best)
{
  // Lower bound of the costs: a perfect match alone is no evidence for uniqueness.
  constexpr int smallest = 100;
  int other = std::numeric_limits<int>::max() / 200;
  for (int i = 0; i < static_cast<int>(sums.size()); ++i)
    if (std::abs(i - best) > 1)
      other = std::min(other, sums[static_cast<std::size_t>(i)]);
  const int minimum = std::max(sums[static_cast<std::size_t>(best)], smallest);
  return static_cast<std::uint8_t>(
      std::clamp(100 * (other - minimum) / minimum, 0, 100));
}

} // namespace pcl::acmap
