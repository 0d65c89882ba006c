#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Pairs stamps of two lists: of all pairs no further apart than the gap the
 * nearest first, each stamp once; equally near ones by their order.
 * \param[in] first rising, seconds
 * \param[in] second rising, seconds
 * \param[in] gap seconds
 * \return indices into both, in the order of the first list. O(n log n) */
std::vector<std::pair<std::size_t, std::size_t>>
matchStamps(const std::vector<double>& first,
            const std::vector<double>& second,
            double gap);

} // namespace pcl::acmap
