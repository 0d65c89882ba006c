#pragma once

#include "chain/egomotion_view.h"

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Share of the surface blocks of one view that contradict the other, among
 * those that can be compared: blocks that would be clearly in front of what the other
 * view saw there. Returns the larger of both shares; for a correct motion it is almost
 * 0. */
double
contradictedShare(const EgomotionView& source,
                  const EgomotionView& target,
                  const Eigen::Isometry3d& T_target_source);

} // namespace pcl::acmap
