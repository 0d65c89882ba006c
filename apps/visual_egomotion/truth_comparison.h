#pragma once

#include "observation_list.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/visual_odometry.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Reads the true poses of a sequence's observations, metres: as many rows as
 * observations, else those that the numbers in their names tell, with a warning.
 * \return one an observation; none when there is no path
 * \throws InputFileException when it cannot be read, or an observation has no row, or no
 * number where it needs one */
std::vector<Eigen::Isometry3d>
loadTruth(Tool& tool, const std::string& path, const ObservationList& list);

/** \brief How far a run is from the truth. */
struct TruthComparison {
  std::vector<Eigen::Isometry3d> truth; ///< of all, in the map of the run
  RelativePoseError relative;           ///< from each posed observation to the next
  AbsoluteTrajectoryError absolute;     ///< of the posed ones
  bool is_way = true; ///< whether the truth moves, so that errors are a part of its way
};

/** \param[in] truth in any map
 * \param[in] run with at least one pose
 * \param[in] is_rigid whether the camera moved freely; else places are compared on the
 * floor */
TruthComparison
compare(std::vector<Eigen::Isometry3d> truth,
        const VisualOdometryResult& run,
        bool is_rigid);

} // namespace pcl::acmap
