#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/chart_clip.h>
#include <pcl/core/impl/yaml_node.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief A plane of the simulated scene, in the frame of the true trajectory. */
struct TruePlane {
  std::string name;
  Eigen::Vector4d coefficients = Eigen::Vector4d::UnitZ(); ///< unit normal; metres
  std::size_t points = 0; ///< number of points that were, or could be, measured on it
  std::vector<acmap::ChartClip> rectangles;
};

/** \brief The ground truth of a simulated session. */
struct SessionTruth {
  std::vector<TruePlane> planes; ///< at least one of them with points
  Trajectory trajectory;         ///< T_map_camera of its observations
  std::string trajectory_path;   ///< path of the trajectory, for messages

  /** \brief Indices of the planes that a map of the session should have: those with at
   * least 1 % of all points. In a corridor these are floor, ceiling, walls, ends that
   * were seen, and doors if there are many. */
  ACMAP_EXPORT std::vector<std::size_t>
  mainPlanes() const;
};

/** \brief Reads truth.json and trajectory.txt of a folder that pcl_simulated_rig wrote.
 * \throws InputFileException naming the file and its fault: one that is missing or
 * cannot be understood, a plane without `points`, a normal that is not of unit length,
 * corners of no rectangle, no plane that has points */
ACMAP_EXPORT SessionTruth
loadSessionTruth(const std::string& folder);

namespace acmap {

/** \brief Reads the planes of a truth.json.
 * \throws InputFileException likewise */
ACMAP_EXPORT std::vector<TruePlane>
readTruePlanes(const YamlNode& file);

} // namespace acmap
} // namespace pcl
