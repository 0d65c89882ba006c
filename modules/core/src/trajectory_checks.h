#pragma once

#include <pcl/core/trajectory.h>

namespace pcl::acmap {

/** \brief Checks that a trajectory can be written.
 * \throws BadArgumentException if the numbers of stamps and poses differ, a value is
 * not finite or a pose is not a rigid motion */
void
requireTrajectory(const Trajectory& trajectory);

} // namespace pcl::acmap
