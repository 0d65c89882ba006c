#pragma once

#include "odometry_prior.h"
#include "plane_landmarks.h"

#include <pcl/mapping/plane_adjustment_types.h>

namespace pcl::acmap {

/** \brief Judges poses by rays, which the adjustment does not use: the space before a
 * piece was free when it was measured. The rays to the centres of at most 192 pieces of
 * each view are compared with the pieces of all other views. A ray is contradicted
 * where it passes, at less than 53 degrees from the normal, through a piece that is
 * more than 0.1 m and three standard deviations before its end. O(rays times pieces
 * along a ray). */
RayContradictions
contradictionsOf(const PiecesOfViews& pieces, const Poses& poses);

} // namespace pcl::acmap
