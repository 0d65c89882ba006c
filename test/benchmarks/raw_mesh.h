#pragma once

#include <pcl/surface/impl/dewall_kernel.h>

#include <string>

namespace pcl::acmap::bench {

struct RawMesh {
  TriangleMesh mesh;
  DeWallReport report;
};

/** \brief Meshes points without prior knowledge: automatic edge length, no normals or
 * sensors. */
RawMesh
meshRaw(const PointView& points, DeWallRule rule, unsigned threads = 1);

/** \brief "DeWall paper" or "DeWall dense". */
std::string
ruleName(DeWallRule rule);

} // namespace pcl::acmap::bench
