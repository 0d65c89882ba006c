#pragma once

#include "facing.h"
#include "spacing.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief For each point the unit normal towards the free space in front of its surface
 * (\ref FreeSpace), if no sensor is known.
 *
 * Neighbours with similar normals form patches, each of which faces one side: that of the
 * majority of a sample of its points. Points that are in no patch, at creases and in
 * clutter, have the side of their neighbours; zero if none of these has one.
 * \param[in] spacing of the tree
 * \param[in] normals of the array from which the points of the tree are, with any sign; where
 * they have no unit length, normals are fitted. May be empty
 * \param[in] up unit vector */
LargeVector<Eigen::Vector3f>
freeSpaceNormals(const PointTree& tree,
                 const Spacing& spacing,
                 const PointView& normals,
                 const Eigen::Vector3d& up);

} // namespace pcl::acmap::ACMAP_DEWALL
