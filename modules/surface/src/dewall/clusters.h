#pragma once

#include "growing_mesh.h"
#include "size_constraint.h"

namespace pcl::acmap::dewall {

/** \brief Number of connected clusters of at least three points ([P] II-C.1): points are
 * connected when a chain of edges within the size constraint joins them. No triangle
 * joins two clusters; the front starts anew in each, so that they need not be known
 * before, and counting starts from what the triangles joined. */
std::size_t
countClusters(const PointTree& tree,
              const SizeConstraint& size,
              const std::vector<TriangleList>& lists);

} // namespace pcl::acmap::dewall
