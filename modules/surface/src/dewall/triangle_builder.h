#pragma once

#include "front.h"

#include <vector>

namespace pcl::acmap::dewall {

/** \brief Triangle_Builder of [P] Fig. 6: first the wall of the splitting plane, then
 * each half with apexes of its own.
 *
 * \param[in] node of the tree whose points are triangulated
 * \param[in] sides of the walls above with both ends among its points
 * \param[in] depth of the node, 0 at the top
 * \param[in] leaf_size halves of at most so many points are grown without a further
 * wall
 */
void
buildTriangles(const PointTree& tree,
               GrowingMesh& mesh,
               Front& front,
               std::int32_t node,
               const std::vector<Side>& sides,
               std::uint8_t depth,
               std::int32_t leaf_size);

} // namespace pcl::acmap::dewall
