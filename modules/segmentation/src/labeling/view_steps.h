#pragma once

#include "labeling/plane_sums.h"

#include <pcl/core/impl/moments.h>

#include <vector>

namespace pcl::acmap::labeling {

/** Maximum offset between parts of one plane due to pose errors, metres. */
constexpr double max_drift = 0.06;

/** The step height between two planes in the individual observations.
 *
 * With pose errors, the observations of one floor lie at several heights, and the
 * merged cloud contains several planes. Within one observation the floor is one plane,
 * and a true step is visible as a step. Therefore the observations that contain both
 * planes decide between these cases. */
class ViewSteps {
public:
  ViewSteps(const Survey& survey,
            const PointLabels& labels,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes);

  /** Returns true if the observations that contain both planes rule out the offset that
   * the part has from the whole in the map: the observed step is less than half of it,
   * and at most the permitted deviation. Returns false if no observation contains both.
   * \param[in] gap offset of the part from the plane of the whole in the map, metres
   * \param[in] tolerance metres; maximum deviation between parts of one plane */
  bool
  ruleOut(double gap, double tolerance, std::size_t part, std::size_t whole) const;

private:
  /** The points of one plane in one observation, relative to the centre of the plane's
   * patch. */
  struct Seen {
    std::int32_t observation;
    Moments moments;
  };

  const std::vector<KnownPlane>& planes_;
  std::vector<std::vector<Seen>> seen_; ///< by plane, then by observation
};

} // namespace pcl::acmap::labeling
