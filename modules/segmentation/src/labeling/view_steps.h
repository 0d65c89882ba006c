#pragma once

#include "labeling/plane_sums.h"

#include <pcl/core/moments.h>

#include <vector>

namespace pcl::acmap::labeling {

/** Parts of one plane lie no farther apart than this because poses err, metres. */
constexpr double max_drift = 0.06;

/** The height of one plane over another as the single observations saw it.
 *
 * Where poses err, the observations of one floor lie at several heights, and what they
 * merge to are several planes. Within one observation the floor is one plane, and a true
 * step is a step. So observations that see both planes decide which of the two it is. */
class ViewSteps {
public:
  ViewSteps(const Survey& survey,
            const std::vector<std::int32_t>& labels,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes);

  /** Tells whether the observations that see both planes rule out that the part stands as
   * far from the whole as it does in the map: they see less than half of that, and no more
   * than one plane may deviate. False where no observation sees both.
   * \param[in] gap metres, of the part from the plane of the whole in the map
   * \param[in] tolerance metres; what one plane may deviate from itself */
  bool
  ruleOut(double gap, double tolerance, std::size_t part, std::size_t whole) const;

private:
  /** The points of one plane in one observation, about the center of the plane's patch. */
  struct Seen {
    std::int32_t observation;
    Moments moments;
  };

  const std::vector<KnownPlane>& planes_;
  std::vector<std::vector<Seen>> seen_; ///< by plane, then by observation
};

} // namespace pcl::acmap::labeling
