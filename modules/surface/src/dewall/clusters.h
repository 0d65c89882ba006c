#pragma once

#include "growing_mesh.h"
#include "size_constraint.h"

namespace pcl::acmap::dewall {

/** \brief Returns the number of connected clusters of at least three points ([P]
 * II-C.1): two points are connected if there is a chain of edges between them that
 * satisfies the size constraint. No triangle connects two clusters. The front is seeded
 * again in each cluster, so the clusters need not be known before, and counting starts
 * from the points that are connected by triangles. */
std::size_t
countClusters(const PointTree& tree,
              const SizeConstraint& size,
              const std::vector<TriangleList>& lists);

} // namespace pcl::acmap::dewall
