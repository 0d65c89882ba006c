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

/** \brief 24 observations of a small simulated room, made once a program, whose
 * trajectory.txt drifts. */
struct DriftedRoom {
  std::string session; ///< folder
  Trajectory truth;
  Trajectory drifted; ///< that of the folder
};

const DriftedRoom&
driftedRoom();

/** \brief A copy of the folder, which may be spoilt. \return its path */
std::string
copyOfRoom(const std::string& folder);

/** \brief A path whose actions turn a bit too far and go a bit too long. */
Trajectory
withDrift(const Trajectory& trajectory);

/** \brief Mean distance of the places of two trajectories, metres. */
double
meanError(const Trajectory& a, const Trajectory& b);

/** \brief A CARMEN log of a laser that goes round in a room of 9 m by 6 m with a
 * pillar: 60 scans of 180 beams, the right two of which have no echo.
 * \param[in] drifts whether the poses drift */
std::string
roomLog(bool drifts);

/** \brief Where the laser of \ref roomLog stood. */
Trajectory
roomLogTruth();

} // namespace pcl::acmap::test
