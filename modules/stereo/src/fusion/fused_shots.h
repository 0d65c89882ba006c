#pragma once

#include <pcl/stereo/matched_disparity.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief How the disparities of a pixel become one. */
enum class ShotStatistic { Median, ConsistentMean };

/** \brief Fuses shots that were matched one by one, pixel by pixel. One without any
 * disparity has the commonest of its outcomes, of equally common ones the first. Runs in
 * the caller's arena; O(pixels * shots).
 * \param[in] shots of one size, at least one; their support is not looked at
 * \param[in] least_support shots that a disparity must rest on */
MatchedDisparity
fuseShots(const std::vector<MatchedDisparity>& shots,
          ShotStatistic statistic,
          std::size_t least_support);

/** \brief No disparity anywhere. */
MatchedDisparity
noDisparity(int width, int height, DisparityOutcome why);

} // namespace pcl::acmap
