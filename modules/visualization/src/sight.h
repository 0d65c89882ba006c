#pragma once

#include "map_camera.h"

namespace pcl::acmap {

/** \brief An eye and a level direction. */
struct Sight {
  Eigen::Vector3d eye;
  Eigen::Vector3d direction;
};

/** \brief From which of some poses, and whither along the walls of a map, one sees
 * farthest.
 * \param[in] middle the eye where there is no pose */
Sight
longestSight(const Trajectory& trajectory,
             const std::vector<MapFaces>& faces,
             const Eigen::Vector3d& middle,
             const MapFrame& frame);

} // namespace pcl::acmap
