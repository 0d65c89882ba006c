#pragma once

#include "map_actors.h"

#include <optional>

namespace pcl::acmap {

/** \brief What a plan leaves out, so that one sees the floor. */
bool
looksDown(const PlanePatch& plane, const Eigen::Vector3d& up);

/** \brief Median height of the finite poses along up, metres; nothing without one. */
std::optional<double>
eyeLevel(const Trajectory& trajectory, const Eigen::Vector3d& up);

/** \brief Walls as a plan shows them, dark where they are cut and pale where they are lower
 * or higher, as above a door; and the trajectory. Above all else, for an eye far above.
 * \param[in] samples points spread over the map */
Actors
actorsOfPlan(const CompactMap& map,
             const Eigen::Vector3d& up,
             const std::vector<Eigen::Vector3f>& samples);

} // namespace pcl::acmap
