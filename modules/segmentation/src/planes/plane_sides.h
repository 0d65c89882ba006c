#pragma once

#include "planes/known_planes.h"

#include <pcl/core/sensor_view.h>

#include <cstddef>

namespace pcl::acmap::planes {

/** Result of \ref turnToSensors. */
struct PlaneSides {
  std::size_t turned = 0;  ///< planes whose normal faced away from their sensors
  std::size_t removed = 0; ///< planes through their sensors
};

/** Turns the normal of each plane to the sensors of its points, each of which has a vote. A
 * plane that passes through the sensors of most of its points is removed: it is a ring of a
 * scanner, or a sheet of its rays, and no surface, which could not be seen from there.
 * \param[in] points whose sensors are known; others have no vote
 * \param[in,out] labels plane of each of these points
 * \param[in,out] known planes, and the labels of the hypotheses */
PlaneSides
turnToSensors(const PointView& points,
              const SensorView& sensors,
              PointLabels& labels,
              KnownPlanes& known);

} // namespace pcl::acmap::planes
