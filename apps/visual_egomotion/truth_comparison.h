#pragma once

#include "observation_list.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/visual_odometry.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Reads the true poses of a sequence's observations, metres. If the number of
 * rows differs from that of the observations, rows are selected by the numbers in the
 * file names, with a warning.
 * \return one per observation; empty if there is no path
 * \throws InputFileException when it cannot be read, or an observation has no row, or
 * no number where it needs one */
std::vector<Eigen::Isometry3d>
loadTruth(Tool& tool, const std::string& path, const ObservationList& list);

/** \brief Deviation of a run from the truth. */
struct TruthComparison {
  std::vector<Eigen::Isometry3d> truth; ///< of all observations, in the map of the run
  RelativePoseError relative;           ///< from each posed observation to the next
  AbsoluteTrajectoryError absolute;     ///< of the posed observations
  /** \brief True if the truth moves, so that errors can be relative to its length. */
  bool is_way = true;
};

/** \param[in] truth in any map
 * \param[in] run with at least one pose
 * \param[in] is_rigid true if the camera moved freely; otherwise positions are compared
 * on the floor */
TruthComparison
compare(std::vector<Eigen::Isometry3d> truth,
        const VisualOdometryResult& run,
        bool is_rigid);

} // namespace pcl::acmap
