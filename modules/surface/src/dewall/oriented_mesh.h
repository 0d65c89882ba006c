#pragma once

#include "triangle_builder.h"

#include <pcl/core/triangle_mesh.h>

#include <pcl/surface/dewall_types.h>

namespace pcl::acmap::dewall {

/** \brief The grown triangles as a mesh of source indices, every component turned as a
 * whole to its face where that is known, else towards the sensor (by projected area);
 * fills the report's counts of the mesh.
 */
TriangleMesh
orientedMesh(GrowingMesh& grown,
             const std::vector<TriangleList>& lists,
             const Eigen::Vector3d& sensor_origin,
             bool compute_wall_depth,
             DeWallReport& report);

} // namespace pcl::acmap::dewall
