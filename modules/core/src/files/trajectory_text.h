#pragma once

#include <pcl/core/trajectory.h>

#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementation of \ref loadTrajectory.
 * \throws InputFileException naming line and fault */
Trajectory
readTrajectory(ByteSource& source);

/** \brief Returns the text that \ref saveTrajectory writes.
 * \throws BadArgumentException as \ref saveTrajectory */
std::string
trajectoryText(const Trajectory& trajectory);

/** \brief Checks that a trajectory can be written.
 * \throws BadArgumentException if the numbers of stamps and poses differ, a value is
 * not finite or a pose is not a rigid motion */
void
requireTrajectory(const Trajectory& trajectory);

} // namespace pcl::acmap
