#pragma once

#include <pcl/core/point_view.h>
#include <pcl/core/triangle_mesh.h>

#include <vector>

namespace pcl::acmap::voting {

/** What a triangle says about the surface. */
struct Face {
  Eigen::Vector3f normal; ///< unit
  Eigen::Vector3f center; ///< as seen from its first corner: exact far from the origin
  float area = 0;         ///< 0: it has no say
};

std::vector<Face>
facesOf(const PointView& points, const std::vector<TriangleMesh::Triangle>& triangles);

} // namespace pcl::acmap::voting
