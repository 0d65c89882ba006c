#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

namespace pcl {

/** \brief Returns the axis of the map frame, x, y, z or its opposite, that is closest
 * to the up direction.
 *
 * The up direction is that of the map (\ref CompactMap::up); if it is unknown, the mean
 * up direction of the cameras of the trajectory; without a trajectory what is assumed
 * (\ref CompactMap::assumed_up). If nothing is, the result is -y, as in a camera frame, or z if
 * the extent of the map along z is smaller than along y and the area of horizontal planes is
 * larger with respect to z. \ingroup core */
ACMAP_EXPORT Eigen::Vector3d
upAxis(const CompactMap& map);

/** \brief The up direction of the map (\ref CompactMap::up); if it is unknown, it is
 * estimated from the planes: the direction with respect to which most of their area is
 * horizontal or vertical.
 *
 * The map frame is that of its first camera, and is tilted if that camera was tilted.
 * If there are several such directions, for example the three axes of a room, the one
 * closest to the up direction of the cameras is returned; without cameras, the one
 * closest to \ref upAxis. Only directions within 60 degrees of it are considered. If
 * less than a third of the area agrees, or if the direction is less than half a degree
 * from the axis, the axis is returned.
 * \return a unit vector in the frame of the map. \ingroup core */
ACMAP_EXPORT Eigen::Vector3d
upDirection(const CompactMap& map);

} // namespace pcl
