#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Matches the stamps of two lists greedily: of all pairs within the gap the
 * closest one first, each stamp at most once; equally close pairs in their order.
 * \param[in] first increasing, seconds
 * \param[in] second increasing, seconds
 * \param[in] gap seconds
 * \return indices into both, in the order of the first list. O(n log n) */
std::vector<std::pair<std::size_t, std::size_t>>
matchStamps(const std::vector<double>& first,
            const std::vector<double>& second,
            double gap);

} // namespace pcl::acmap
