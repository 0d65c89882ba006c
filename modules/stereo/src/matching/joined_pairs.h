#pragma once

#include "pair_match.h"

#include <pcl/stereo/matched_disparity.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief How two pairs become one. */
struct JoinSettings {
  double ratio = 1.0;     ///< baseline of the first pair over that of the second
  double agreement = 1.0; ///< px of the first pair
  bool require_agreement = false;
};

/** \brief What one pair tells. \param[in] support shots */
void
takePair(const PairMatch& pair, std::uint16_t support, MatchedDisparity& matched);

/** \brief What two pairs tell, in disparities of the first: where both are sure and agree,
 * the mean by their variances; else the one that is much surer, the one that correlates
 * better, or the one that is there.
 * \return pixels for which both agree */
std::size_t
joinPairs(const PairMatch& first,
          const PairMatch& second,
          const JoinSettings& settings,
          std::uint16_t support,
          MatchedDisparity& matched);

} // namespace pcl::acmap
