#pragma once

#include <pcl/stereo/matched_disparity.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief How the disparities of a pixel are combined. */
enum class ShotStatistic { Median, ConsistentMean };

/** \brief Fuses shots that were matched separately, pixel by pixel. A pixel without any
 * disparity gets the most frequent outcome of the shots, the first one in case of ties.
 * Runs in the caller's arena; O(pixels * shots).
 * \param[in] shots of one size, at least one; their support is not read
 * \param[in] min_support minimum number of shots for a disparity */
MatchedDisparity
fuseShots(const std::vector<MatchedDisparity>& shots,
          ShotStatistic statistic,
          std::size_t min_support);

/** \brief Returns an image without any disparity. */
MatchedDisparity
noDisparity(int width, int height, DisparityOutcome why);

} // namespace pcl::acmap
