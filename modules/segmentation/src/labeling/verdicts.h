#pragma once

#include "labeling/plane_sums.h"
#include "labeling/view_steps.h"

namespace pcl::acmap::labeling {

/** For each plane: its own number, the number of the plane of which it is a part, or
 * -1. */
struct Verdicts {
  std::vector<std::int32_t> kept_as;
  std::size_t merged = 0;

  /** For each plane the maximum offset of its parts due to pose errors, metres; 0 for
   * most. */
  std::vector<double> drift;

  std::size_t refuted = 0; ///< the points deviate, or do not determine the tilt
};

/** Verifies planes by their points. A plane is refuted if its points deviate from it by
 * more than their noise. A small plane is also refuted if its tilt remains unknown. A
 * plane becomes a part of a previous one if both are the same within their uncertainty,
 * or if they differ in the map but not in those observations that contain both.
 * \param[in] shadows see \ref findShadows; they become parts of the planes that cause
 * them
 * \param[in] distance metres; maximum deviation between parts of one plane
 * \param[in] cosine minimum, between normals of parts of one plane */
Verdicts
judge(const std::vector<PlaneSums>& sums,
      const ViewSteps& steps,
      const std::vector<std::int32_t>& shadows,
      const std::vector<KnownPlane>& planes,
      double distance,
      double cosine);

} // namespace pcl::acmap::labeling
