#pragma once

#include "plane_input.h"
#include "simulated_clouds.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief The planes that really are in a cloud, in its frame. */
struct PlaneTruth {
  std::vector<TruthPlane> planes;
  std::vector<std::int32_t> labels; ///< for each point index of its plane, -1 none
};

/** \brief A simulated cloud in which planes are looked for. */
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

/** \brief The common planes of the doors on a side. */
bool
isDoorPlane(const TruthPlane& plane);

} // namespace pcl::acmap::bench
