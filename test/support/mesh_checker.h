#pragma once

#include "point_tree.h"

#include <pcl/Vertices.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/point_cloud.h>

#include <functional>
#include <iosfwd>
#include <limits>

namespace pcl::acmap::test {

using Triangle = TriangleMesh::Triangle;
using Triangles = TriangleMesh::Triangles;

/** \brief Size constraint: is an edge between two points allowed? */
using EdgeAllowed = std::function<bool(std::int32_t, std::int32_t)>;

/** \brief The size constraint "no edge longer than \a length". */
EdgeAllowed
noLongerThan(const Points& points, double length);

/** \brief Everything that can be wrong with a mesh; all numbers are zero for a valid
 * mesh. */
struct MeshFaults {
  std::size_t invalid_faces = 0;      ///< a vertex out of range or not finite
  std::size_t degenerate_faces = 0;   ///< a repeated vertex or no area
  std::size_t duplicate_faces = 0;    ///< same three vertices as an earlier face
  std::size_t crowded_edges = 0;      ///< more than two faces
  std::size_t torn_vertices = 0;      ///< several fans, or a crowded edge
  std::size_t inconsistent_edges = 0; ///< traversed by two faces in the same direction
  std::size_t forbidden_edges = 0;    ///< violate the size constraint
  std::size_t occupied_spheres = 0;   ///< a point inside the smallest circumsphere

  std::size_t
  total() const;
};

std::ostream&
operator<<(std::ostream& stream, const MeshFaults& faults);

/** \brief Elements of a mesh. Faces with invalid or repeated vertices are not
 * counted. */
struct MeshCounts {
  std::size_t faces = 0;
  std::size_t used_points = 0;
  std::size_t edges = 0;
  std::size_t boundary_edges = 0; ///< with one face
  std::size_t components = 0;     ///< of faces that share edges
  std::size_t boundary_loops = 0; ///< connected sets of boundary edges
};

/** \brief Selects checks and their thresholds. */
struct MeshDemands {
  EdgeAllowed edge_allowed;       ///< empty: any length
  bool empty_spheres = false;     ///< \ref MeshFaults::occupied_spheres is counted
  double sphere_tolerance = 1e-6; ///< of the radius
  double min_area_ratio = 1e-10;  ///< twice the area divided by the square of the
                                  ///< longest edge
};

/** \brief Finds every fault by brute force, independently of the tested kernels. */
MeshFaults
checkMesh(const Points& points,
          const Triangles& faces,
          const MeshDemands& demands = {});

MeshCounts
countMesh(const Points& points, const Triangles& faces);

/** \brief Smallest sphere through three points; infinite radius if they are
 * collinear. */
struct SmallestSphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = std::numeric_limits<double>::infinity();
};

SmallestSphere
smallestCircumsphere(const Eigen::Vector3d& a,
                     const Eigen::Vector3d& b,
                     const Eigen::Vector3d& c);

/** \brief Twice the area divided by the square of the longest edge; 0 if corners
 * coincide. */
double
areaRatio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

template <typename PointT>
Points
toPoints(const PointCloud<PointT>& cloud)
{
  Points points;
  points.reserve(cloud.size());
  for (const PointT& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  return points;
}

/** \brief Triangles of PCL polygons; polygons with more corners are split into fans. */
Triangles
toTriangles(const std::vector<Vertices>& polygons);

} // namespace pcl::acmap::test
