#pragma once

#include "voting_meshes.h"

namespace pcl::acmap::test {

/** \brief The surface of a cube with \a side squares along each edge, centred at the
 * origin, oriented outwards. */
VotingMesh
makeCubeMesh(int side, double spacing);

/** \brief An icosahedron whose faces are split into four, \a levels times. */
VotingMesh
makeSphereMesh(int levels, double radius);

} // namespace pcl::acmap::test
