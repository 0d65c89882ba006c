#pragma once

#include "triangle_builder.h"

#include <pcl/core/triangle_mesh.h>

#include <pcl/surface/dewall_types.h>

namespace pcl::acmap::dewall {

/** \brief Converts the grown triangles to a mesh of source indices. Each component is
 * oriented as a whole, by the facing directions if known, otherwise towards the sensor
 * (by projected area). The report's counts of the mesh are set. */
TriangleMesh
orientedMesh(GrowingMesh& grown,
             const std::vector<TriangleList>& lists,
             const Eigen::Vector3d& sensor_origin,
             bool compute_wall_depth,
             DeWallReport& report);

} // namespace pcl::acmap::dewall
