#pragma once

#include "run_tool.h"

#include <pcl/core/trajectory.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Runs pcl_entropy_rectification. */
ToolRun
runRectification(const std::vector<std::string>& arguments,
                 const RunSettings& settings = {});

/** \brief 24 observations of a small simulated room, made once per program, with a
 * drifting trajectory.txt. */
struct DriftedRoom {
  std::string session; ///< folder
  Trajectory truth;
  Trajectory drifted; ///< the trajectory in the folder
};

const DriftedRoom&
driftedRoom();

/** \brief A copy of the folder, which a test may modify. \return its path */
std::string
copyOfRoom(const std::string& folder);

/** \brief A trajectory whose actions rotate and translate a bit too far. */
Trajectory
withDrift(const Trajectory& trajectory);

/** \brief Mean distance between the positions of two trajectories, metres. */
double
meanError(const Trajectory& a, const Trajectory& b);

/** \brief A CARMEN log of a laser that moves around in a room of 9 m by 6 m with a
 * pillar: 60 scans of 180 beams, the right two of which have no echo.
 * \param[in] drifts true if the poses drift */
std::string
roomLog(bool drifts);

/** \brief True poses of the laser of \ref roomLog. */
Trajectory
roomLogTruth();

} // namespace pcl::acmap::test
