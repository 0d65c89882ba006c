#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** The median; for an even number of values the upper one of the two in the middle; 0
 * if empty.
 * \param[in,out] values they are reordered */
template <typename Allocator>
double
medianOf(std::vector<double, Allocator>& values)
{
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace pcl::acmap
