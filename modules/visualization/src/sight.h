#pragma once

#include "map_camera.h"

namespace pcl::acmap {

/** \brief Position of an eye and a horizontal direction. */
struct Sight {
  Eigen::Vector3d eye;
  Eigen::Vector3d direction;
};

/** \brief Selects the pose and the direction along the walls of a map with the longest
 * view.
 * \param[in] middle position that is used if there is no pose */
Sight
longestSight(const Trajectory& trajectory,
             const std::vector<MapFaces>& faces,
             const Eigen::Vector3d& middle,
             const MapFrame& frame);

} // namespace pcl::acmap
