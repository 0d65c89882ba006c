#pragma once

#include <pcl/core/point_view.h>
#include <pcl/core/triangle_mesh.h>

#include <vector>

namespace pcl::acmap::voting {

/** Contribution of a triangle to the votes. */
struct Face {
  Eigen::Vector3f normal; ///< unit
  /** \brief Centre relative to the first corner: accurate far from the origin. */
  Eigen::Vector3f center;
  float area = 0; ///< 0: it does not vote
};

std::vector<Face>
facesOf(const PointView& points, const std::vector<TriangleMesh::Triangle>& triangles);

} // namespace pcl::acmap::voting
