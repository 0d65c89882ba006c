#pragma once

#include "voting_meshes.h"

namespace pcl::acmap::test {

/** \brief The surface of a cube of \a side squares along each edge, about the origin,
 * seen from outside. */
VotingMesh
makeCubeMesh(int side, double spacing);

/** \brief An icosahedron with each face parted in four, \a levels times. */
VotingMesh
makeSphereMesh(int levels, double radius);

} // namespace pcl::acmap::test
