#pragma once

#include <pcl/core/trajectory.h>

#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief The reader behind \ref loadTrajectory.
 * \throws InputFileException naming line and fault */
Trajectory
readTrajectory(ByteSource& source);

/** \brief What \ref saveTrajectory writes.
 * \throws BadArgumentException likewise */
std::string
trajectoryText(const Trajectory& trajectory);

} // namespace pcl::acmap
