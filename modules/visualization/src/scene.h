#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The drawn part of a cloud and a mesh: finite points only; of a mesh only
 * those that are vertices of triangles. */
struct Scene {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::array<std::uint8_t, 3>> colors; ///< of the points; may be empty
  TriangleMesh::Triangles triangles;               ///< indices into points
  std::vector<std::uint8_t> wall_depth;            ///< of the triangles; may be empty

  bool
  isMesh() const
  {
    return !triangles.empty();
  }
};

/** \throws BadArgumentException when the mesh has an index outside the cloud, the
 * number of wall depths differs from that of the triangles, or the cloud has no x y z
 * \throws InitFailedException when nothing can be drawn */
Scene
makeScene(const PCLPointCloud2& cloud, const TriangleMesh& mesh);

/** \brief Area-weighted mean of the normals of the triangles; zero without
 * triangles. */
Eigen::Vector3d
meanNormal(const Scene& scene);

/** \brief Splits polygons into triangle fans. */
TriangleMesh
trianglesOf(const PolygonMesh& mesh);

/** \brief Edges that belong to one triangle only. */
std::vector<std::array<std::int32_t, 2>>
boundaryEdges(const TriangleMesh::Triangles& triangles);

/** \brief Lines at the vertices along the area-weighted mean normals of their
 * triangles. Every nth vertex is used, so that there are at most 3000. Their length is
 * proportional to the size of the scene. */
std::vector<std::array<Eigen::Vector3f, 2>>
normalLines(const Scene& scene);

} // namespace pcl::acmap
