#pragma once

#include <pcl/core/trajectory.h>

namespace pcl::acmap {

/** \brief Lets trajectories pass that can be written.
 * \throws BadArgumentException when stamps and poses differ in number, a value is not
 * finite or a pose no rigid motion */
void
requireTrajectory(const Trajectory& trajectory);

} // namespace pcl::acmap
