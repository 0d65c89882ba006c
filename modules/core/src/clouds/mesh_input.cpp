#include <pcl/core/exceptions.h>
#include <pcl/core/impl/mesh_input.h>

namespace pcl::acmap {

TriangleMesh::Triangles
trianglesOf(const std::vector<Vertices>& polygons)
{
  TriangleMesh::Triangles triangles;
  triangles.reserve(polygons.size());
  for (const Vertices& polygon : polygons)
    for (std::size_t k = 2; k < polygon.vertices.size(); ++k)
      triangles.push_back(
          {polygon.vertices[0], polygon.vertices[k - 1], polygon.vertices[k]});
  return triangles;
}

void
requireCornersInside(const TriangleMesh::Triangles& triangles, std::size_t points)
{
  for (const TriangleMesh::Triangle& triangle : triangles)
    for (const std::int32_t corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        throw acmap::InitFailed("the mesh has a corner ",
                                corner,
                                " outside of the input cloud of ",
                                points,
                                " points");
}

} // namespace pcl::acmap
