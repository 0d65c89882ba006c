#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::acmap::bench {

/** \brief The value that a fraction \a share of all values do not exceed; NaN if there
 * are none. */
inline double
quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto place =
      std::min(values.size() - 1,
               static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const auto found = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

inline double
median(std::vector<double> values)
{
  return quantile(std::move(values), 0.5);
}

inline double
percent(std::size_t part, std::size_t whole)
{
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

} // namespace pcl::acmap::bench
