#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl {

/** \brief Where the camera was at each observation of a sequence. \ingroup core */
struct Trajectory {
  std::vector<double> stamps;           ///< seconds
  std::vector<Eigen::Isometry3d> poses; ///< T_map_camera, metres
};

namespace acmap {

/** \brief Name of the file with the poses of the observations of a folder. */
constexpr const char* trajectory_name = "trajectory.txt";

} // namespace acmap

/** \brief Is a pose a rigid motion: finite, its rotation orthonormal within 1e-6 and no
 * mirror? \ingroup core */
ACMAP_EXPORT bool
isRigid(const Eigen::Isometry3d& pose);

/** \brief Reads a trajectory in TUM's form: rows of `stamp tx ty tz qx qy qz qw`;
 * blank lines and comments behind # are left out. A quaternion within 1 % of length 1 is
 * normalised.
 * \throws InputFileException naming file, line and fault: a word that is no finite
 * number, too few or too many of them, a quaternion that is no rotation; no row at all
 * \ingroup core */
ACMAP_EXPORT Trajectory
loadTrajectory(const std::string& path);

/** \brief Writes a trajectory in TUM's form, with as many digits as it takes to read the
 * same numbers back. Quaternions have qw >= 0.
 * \throws BadArgumentException when stamps and poses differ in number, a value is not
 * finite or a pose no rigid motion
 * \throws OutputFileException when the file could not be written whole \ingroup core */
ACMAP_EXPORT void
saveTrajectory(const std::string& path, const Trajectory& trajectory);

} // namespace pcl
