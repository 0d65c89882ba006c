#include "voting/vertex_rings.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Geometry>

#include <limits>

namespace pcl::acmap::voting {
namespace {

Face
faceOf(const PointView& points, const TriangleMesh::Triangle& triangle)
{
  const auto corner = [&](int k) -> Eigen::Vector3d {
    return points[static_cast<std::size_t>(triangle[k])].cast<double>();
  };
  const Eigen::Vector3d a = corner(0), b = corner(1), c = corner(2);
  const Eigen::Vector3d cross = (b - a).cross(c - a);
  const double length = cross.norm();
  Face face;
  if (!(length > 0 && length < std::numeric_limits<float>::max()))
    return face;
  face.normal = (cross / length).cast<float>();
  face.center = ((b - a + c - a) / 3).cast<float>();
  face.area = static_cast<float>(length / 2);
  return face;
}

} // namespace

LargeVector<Face>
facesOf(const PointView& points, const TriangleMesh::Triangles& triangles)
{
  LargeVector<Face> faces(triangles.size());
  parallelForChunks(triangles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      faces[t] = faceOf(points, triangles[t]);
  });
  return faces;
}

} // namespace pcl::acmap::voting
