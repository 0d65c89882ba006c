#pragma once

#include "plane_finders.h"
#include "plane_overlaps.h"
#include "plane_truth.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Maximum deviations of a detected plane from its true plane. */
struct MatchLimits {
  double angle = 2;     ///< degrees
  double offset = 0.02; ///< metres, at the centroid of the true plane's points
};

/** \brief Deviation of a detected plane from the true one. */
struct MatchDeviation {
  double angle = 0;  ///< degrees, independent of the signs of the normals
  double offset = 0; ///< metres, at the centroid of the true plane's points
};

/** \brief Assignment of detected planes to true planes. */
struct PlaneMatches {
  std::vector<std::int32_t> finder;      ///< detected plane of each true plane, -1 for
                                         ///< none
  std::vector<MatchDeviation> deviation; ///< of these pairs
  std::size_t spurious = 0;   ///< less than half from one true plane, or too large a
                              ///< deviation
  std::size_t astray = 0;     ///< of these, those with only too large a deviation
  std::size_t duplicates = 0; ///< of true planes for which others have more points
};

PlaneMatches
matchPlanes(const PlaneCase& plane_case,
            const FoundPlanes& found,
            const PlaneOverlaps& overlaps,
            const MatchLimits& limits = {});

} // namespace pcl::acmap::bench
