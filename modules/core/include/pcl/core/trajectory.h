#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/rigid_motion.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl {

/** \brief Pose of the camera at each observation of a sequence. \ingroup core */
struct Trajectory {
  std::vector<double> stamps;           ///< seconds
  std::vector<Eigen::Isometry3d> poses; ///< T_map_camera, metres
};

namespace acmap {

/** \brief Name of the file in a folder that contains the poses of its observations. */
constexpr const char* trajectory_name = "trajectory.txt";

} // namespace acmap

/** \brief Reads a trajectory in TUM format: rows of `stamp tx ty tz qx qy qz qw`; blank
 * lines and comments after # are ignored. A quaternion whose length is within 1 % of 1
 * is normalised.
 * \throws InputFileException naming file, line and fault: a word that is not a finite
 * number, too few or too many of them, a quaternion that is not a rotation; no rows
 * \ingroup core */
ACMAP_EXPORT Trajectory
loadTrajectory(const std::string& path);

/** \brief Writes a trajectory in TUM format, with as many digits as are needed to read
 * back the same numbers. Quaternions have qw >= 0.
 * \throws BadArgumentException if the numbers of stamps and poses differ, a value is
 * not finite or a pose is not a rigid motion
 * \throws OutputFileException when the file could not be written completely
 * \ingroup core */
ACMAP_EXPORT void
saveTrajectory(const std::string& path, const Trajectory& trajectory);

} // namespace pcl
