#pragma once

#include "pair_match.h"

#include <pcl/stereo/matched_disparity.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief How two pairs are joined. */
struct JoinSettings {
  double ratio = 1.0;     ///< baseline of the first pair over that of the second
  double agreement = 1.0; ///< px of the first pair
  bool require_agreement = false;
};

/** \brief Takes the result of a single pair. \param[in] support number of shots */
void
takePair(const PairMatch& pair, std::uint16_t support, MatchedDisparity& matched);

/** \brief Joins the results of two pairs, in disparities of the first: if both are
 * matched and agree, the mean weighted by inverse variances; if they disagree, the one
 * with a much smaller standard deviation or the higher correlation; otherwise the one
 * that is matched.
 * \return the number of pixels for which both agree */
std::size_t
joinPairs(const PairMatch& first,
          const PairMatch& second,
          const JoinSettings& settings,
          std::uint16_t support,
          MatchedDisparity& matched);

} // namespace pcl::acmap
