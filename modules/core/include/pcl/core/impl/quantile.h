#pragma once

#include <pcl/core/build_config.h>

#include <algorithm>
#include <cstddef>

namespace pcl::acmap {

/** \brief The value that is at place \a rank (below the number of values) when they are
 * sorted.
 * \param[in,out] values they are reordered */
template <typename Values>
typename Values::value_type
valueOfRank(Values& values, std::size_t rank)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** \brief The value that a share (below 1) of all values do not exceed; 0 if there are
 * none.
 * \param[in,out] values they are reordered */
template <typename Values>
typename Values::value_type
quantileOf(Values& values, double share)
{
  if (values.empty())
    return {};
  return valueOfRank(
      values, static_cast<std::size_t>(share * static_cast<double>(values.size())));
}

/** \brief The median; for an even number of values the upper one of the two in the
 * middle; 0 if there are none.
 * \param[in,out] values they are reordered */
template <typename Values>
typename Values::value_type
medianOf(Values& values)
{
  return quantileOf(values, 0.5);
}

} // namespace pcl::acmap
