#pragma once

#include "plane_finders.h"
#include "plane_overlaps.h"
#include "plane_truth.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A found plane that deviates more is not the true one. */
struct PlaneLimits {
  double angle = 2;     ///< degrees
  double offset = 0.02; ///< metres, at the centroid of the true plane's points
};

/** \brief What a found plane deviates by from the true one. */
struct PlaneDeviation {
  double angle = 0;  ///< degrees, whatever the signs of the normals
  double offset = 0; ///< metres, at the centroid of the true plane's points
};

/** \brief Which true plane is found by which found one. */
struct PlaneMatches {
  std::vector<std::int32_t> finder;      ///< for each true plane, -1 for none
  std::vector<PlaneDeviation> deviation; ///< of these
  std::size_t spurious = 0;   ///< less than half from one true plane, or too far off it
  std::size_t astray = 0;     ///< of these the ones that are only too far off
  std::size_t duplicates = 0; ///< of true planes that others found with more points
};

PlaneMatches
matchPlanes(const PlaneCase& plane_case,
            const FoundPlanes& found,
            const PlaneOverlaps& overlaps,
            const PlaneLimits& limits = {});

} // namespace pcl::acmap::bench
