#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/plane_sightings.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief How far the parts of each plane that different observations saw are from it: root mean
 * square of the mean distances, without what noise adds to these. Metres; NaN: not known. */
std::vector<double>
roughnessOf(const PlaneSightings& sightings);

/** \brief Root mean square of the roughness of floors, ceilings and walls, by area; of all planes in a
 * map without these. NaN: not known. */
double
unevennessOf(const CompactMap& map, const std::vector<double>& roughness);

/** \brief How far the parts of the same planes that different observations saw in the same cells are from
 * each other: standard deviation, metres; NaN: not known. */
double
disagreementOf(const CompactMap& map, const PlaneSightings& sightings);

/** \brief Share of the rays that pass through no plane where it was seen; NaN without rays. */
double
rayAgreement(const CompactMap& map, const PlaneSightings& sightings);

/** \brief The observation that is joined worst to the others, when each time the one that shares
 * most with those already joined is the next one. */
struct WeakestOverlap {
  double share = std::numeric_limits<double>::quiet_NaN(); ///< NaN: not known
  std::size_t observation = 0;
};

WeakestOverlap
weakestOverlap(const PlaneSightings& sightings);

} // namespace pcl::acmap
