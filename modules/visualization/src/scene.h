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

/** \brief What is drawn of a cloud and a mesh: finite points alone, of a mesh only those
 * that are corners. */
struct Scene {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::array<std::uint8_t, 3>> colors; ///< of the points, or empty
  std::vector<TriangleMesh::Triangle> triangles;   ///< into points
  std::vector<std::uint8_t> wall_depth;            ///< of the triangles, or empty

  bool
  isMesh() const
  {
    return !triangles.empty();
  }
};

/** \return nullptr where there is none of that name */
const PCLPointField*
fieldNamed(const PCLPointCloud2& cloud, const std::string& name);

/** \throws BadArgumentException when the mesh has an index outside the cloud or wall
 * depths of another number than triangles, or the cloud no x y z
 * \throws InitFailedException when nothing can be drawn */
Scene
makeScene(const PCLPointCloud2& cloud, const TriangleMesh& mesh);

/** \brief Mean of the unit normals of the triangles, by area; zero without triangles. */
Eigen::Vector3d
meanNormal(const Scene& scene);

/** \brief Polygons as fans of triangles. */
TriangleMesh
trianglesOf(const PolygonMesh& mesh);

/** \brief Edges with one triangle. */
std::vector<std::array<std::int32_t, 2>>
boundaryEdges(const std::vector<TriangleMesh::Triangle>& triangles);

/** \brief Lines from foot to tip along the mean normals, by area, of the faces at a
 * vertex: of every nth vertex, so that there are 3000 at most. Their length is a share of
 * the scene's box. */
std::vector<std::array<Eigen::Vector3f, 2>>
normalLines(const Scene& scene);

} // namespace pcl::acmap
