#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

namespace pcl {

/** \brief The axis of a map's frame, x, y, z or the opposite of one, that is nearest to
 * up.
 *
 * It is what the cameras of the trajectory take for up on average. Without a trajectory it
 * is -y, as in the frame of a camera, or z where the map stretches less along z than along
 * y and more area is level in z. \ingroup core */
ACMAP_EXPORT Eigen::Vector3d
upAxis(const CompactMap& map);

/** \brief Up as the planes of a map tell: the direction to which most of their area is
 * level or upright.
 *
 * The frame of a map is that of its first camera, and tilted if that was. Of several such
 * directions, as the three of a room, the one nearest to what the cameras take for up is
 * returned; without cameras the one nearest to \ref upAxis. At most 60 degrees from there
 * are looked at. Where less than a third of the area agrees, and where the direction is less
 * than half a degree from the axis, it is the axis.
 * \return a vector of length 1 in the frame of the map. \ingroup core */
ACMAP_EXPORT Eigen::Vector3d
upDirection(const CompactMap& map);

} // namespace pcl
