#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Point clouds of a folder, in the order of the numbers in their names, with what
 * stands beside them. */
struct CloudFolder {
  std::vector<std::string> paths;
  Trajectory trajectory;         ///< as recorded; without poses if they are not known
  std::vector<std::size_t> rows; ///< row in the trajectory, one per cloud
  /** \brief Frame of the clouds in that whose poses were recorded. */
  Eigen::Isometry3d T_recorded_cloud = Eigen::Isometry3d::Identity();
  bool is_recorded = false; ///< Are the poses those of another program's files?
  std::vector<std::string> remarks;
};

/** \brief Lists the clouds of a folder: PCD files; if there are none, PLY, LAS, E57 or XYZ
 * files, or scans of KITTI (.bin), which may stand in its folder velodyne. Hidden files are
 * left out.
 *
 * Poses are those of trajectory.txt, else of poses.txt: rows of 12 numbers, T_world_camera of
 * KITTI, with T_camera_scanner in the row Tr of calib.txt, else of a file for each cloud with a
 * 4 x 4 matrix (<name>.pose.txt, <name>_pose.txt, <name>.pose or <name>.txt). Clouds whose pose
 * was lost are left out. Without poses, times.txt has the times.
 * \throws InputFileException if the folder has no clouds, or a file is malformed */
CloudFolder
openCloudFolder(const std::string& folder);

/** \brief Reads a cloud of any ending; scans of KITTI in the axes of a camera.
 * \param[in] stated scale and shift; those scans have no shift
 * \throws InputFileException as \ref loadPointCloud */
PointCloudFile
loadObservationFile(const std::string& path, const CloudStatement& stated);

} // namespace pcl::acmap
