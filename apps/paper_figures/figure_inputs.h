#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What a simulated session tells of itself and of its building. */
struct FilmedSession {
  std::string folder;
  std::string scene;
  std::size_t observations = 0;
  std::size_t patterns = 0; ///< an observation
  Trajectory trajectory;    ///< the true one

  /** \brief Walls and all else that stands upright, from above, in the frame of the true
   * trajectory: the two ends (y is 0). */
  std::vector<std::array<Eigen::Vector3d, 2>> uprights;
};

/** \brief Reads truth.json and trajectory.txt of a session.
 * \throws InputFileException naming the file and its fault, as when it was no simulation */
FilmedSession
loadFilmedSession(const std::string& folder);

/** \brief Where and how a map of the session was made. */
struct MappedSession {
  std::string folder;
  PCLPointCloud2 points;                 ///< map.pcd: x y z rgb view, map frame
  Trajectory before, after;              ///< of rectification, T_map_camera, row by row
  std::vector<std::string> observations; ///< paths of their clouds
};

/** \brief Reads what pcl_compact_mapping left of the session, but for the map itself.
 * \throws InputFileException naming the file and its fault: one that is missing, poses
 * that differ in number, a map of another session */
MappedSession
loadMappedSession(const std::string& folder, const FilmedSession& session);

} // namespace pcl::acmap
