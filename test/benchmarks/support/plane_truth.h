#pragma once

#include "plane_input.h"
#include "simulated_clouds.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief The true planes of a cloud, in its frame. */
struct PlaneTruth {
  std::vector<TruthPlane> planes;
  std::vector<std::int32_t> labels; ///< plane of each point, -1 for none
};

/** \brief A simulated cloud for plane detection, with its truth. */
struct PlaneCase {
  std::string name;
  PlaneInput input;
  PlaneTruth truth;
};

PlaneCase
makePlaneCase(const SimulatedCloud& cloud);

/** \brief Floor, ceiling, walls and ends of the standard corridor. */
bool
isMainPlane(const TruthPlane& plane);

/** \brief The common planes of the doors on one side of the corridor. */
bool
isDoorPlane(const TruthPlane& plane);

} // namespace pcl::acmap::bench
