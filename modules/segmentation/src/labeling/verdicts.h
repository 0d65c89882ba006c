#pragma once

#include "labeling/plane_sums.h"
#include "labeling/view_steps.h"

namespace pcl::acmap::labeling {

/** What becomes of each plane: its own number, that of the plane it is a part of, or -1. */
struct Verdicts {
  std::vector<std::int32_t> kept_as;
  std::size_t merged = 0;

  /** For each plane how far parts of it lie off it because poses err, metres; 0 for most. */
  std::vector<double> drift;

  std::size_t refuted = 0; ///< the points do not lie on them, or cannot tell their tilt
};

/** Judges planes by their points. A plane is refuted when its points are farther off than
 * their noise; a small one or a strip is also when its tilt stays unknown. Those that lie
 * in the plane of a surer one, as far as both can tell, become part of it; so do those that
 * lie beside it in the map but not in the observations that see both.
 * \param[in] shadows see \ref findShadows; they become part of what casts them
 * \param[in] distance metres; what one plane may deviate from itself
 * \param[in] cosine between normals of one plane */
Verdicts
judge(const std::vector<PlaneSums>& sums,
      const ViewSteps& steps,
      const std::vector<std::int32_t>& shadows,
      const std::vector<KnownPlane>& planes,
      double distance,
      double cosine);

} // namespace pcl::acmap::labeling
