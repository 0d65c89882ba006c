#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Data of a simulated session and its building. */
struct FilmedSession {
  std::string folder;
  std::string scene;
  std::size_t observations = 0;
  std::size_t patterns = 0; ///< per observation
  Trajectory trajectory;    ///< the true one

  /** \brief Walls and all other upright rectangles from above, in the frame of the true
   * trajectory: the two ends (y is 0). */
  std::vector<std::array<Eigen::Vector3d, 2>> uprights;
};

/** \brief Reads truth.json and trajectory.txt of a session.
 * \throws InputFileException naming the file and its fault, for example for a session
 * that was not simulated */
FilmedSession
loadFilmedSession(const std::string& folder);

/** \brief Data of a map of the session. */
struct MappedSession {
  std::string folder;
  PCLPointCloud2 points; ///< map.pcd: x y z rgb view, map frame
  /** \brief Before and after rectification, T_map_camera, the same observations. */
  Trajectory before, after;
  std::vector<std::string> observations; ///< paths of their clouds
};

/** \brief Reads the results of pcl_compact_mapping for the session, except for the map
 * itself.
 * \throws InputFileException naming the file and its fault: one that is missing, poses
 * that differ in number, a map of another session */
MappedSession
loadMappedSession(const std::string& folder, const FilmedSession& session);

} // namespace pcl::acmap
