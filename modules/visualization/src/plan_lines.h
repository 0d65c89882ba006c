#pragma once

#include "map_actors.h"

#include <optional>

namespace pcl::acmap {

/** \brief Does a plane face down? A plan leaves these out, so that the floor is
 * visible. */
bool
looksDown(const PlanePatch& plane, const Eigen::Vector3d& up);

/** \brief Does the middle of a cylinder's arc look down, as a vault does? Closed columns
 * and pipes do not. */
bool
looksDown(const CylinderPatch& cylinder, const Eigen::Vector3d& up);

/** \brief Median height of the finite poses along up, metres; nothing if there are
 * none. */
std::optional<double>
eyeLevel(const Trajectory& trajectory, const Eigen::Vector3d& up);

/** \brief Walls and trajectory of a plan. Walls are dark where they are cut and pale
 * where they are lower or higher, such as above a door. All lines are above the map.
 * \param[in] samples points distributed over the map */
Actors
actorsOfPlan(const CompactMap& map,
             const Eigen::Vector3d& up,
             const std::vector<Eigen::Vector3f>& samples);

} // namespace pcl::acmap
