#include "oriented_mesh.h"

#include "disjoint_sets.h"

namespace pcl::acmap::dewall {

namespace {

/** \brief Components of the mesh, by vertices: under the guarantee of one fan a vertex,
 * triangles that share a vertex are joined by edges too. */
DisjointSets
findComponents(const PointTree& tree, const std::vector<GrownTriangle>& triangles)
{
  DisjointSets components(tree.size());
  for (const GrownTriangle& triangle : triangles) {
    components.unite(triangle.corners[0], triangle.corners[1]);
    components.unite(triangle.corners[0], triangle.corners[2]);
  }
  return components;
}

/** \brief Area a triangle shows to the sensor; negative when it shows its back. */
double
areaFacing(const PointTree& tree,
           const std::array<std::int32_t, 3>& corners,
           const Eigen::Vector3d& sensor)
{
  const Eigen::Vector3d a = tree.position(corners[0]);
  const Eigen::Vector3d b = tree.position(corners[1]), c = tree.position(corners[2]);
  const Eigen::Vector3d view = sensor - (a + b + c) / 3;
  const double distance = view.norm();
  return distance > 0 ? (b - a).cross(c - a).dot(view) / (2 * distance) : 0.0;
}

void
count(const PointTree& tree,
      const std::vector<GrownTriangle>& triangles,
      GrowingMesh& grown,
      DisjointSets& components,
      DeWallReport& report)
{
  report.triangles = triangles.size();
  report.boundary_edges = grown.openSides().size();
  report.edges = (3 * report.triangles + report.boundary_edges) / 2;
  for (std::int32_t v = 0; v < tree.size(); ++v)
    if (grown.isUsed(v)) {
      ++report.used_points;
      report.components += components.find(v) == v;
    }
}

} // namespace

TriangleMesh
orientedMesh(const PointTree& tree,
             GrowingMesh& grown,
             const Facing& facing,
             const Eigen::Vector3d& sensor_origin,
             bool compute_wall_depth,
             DeWallReport& report)
{
  const std::vector<GrownTriangle>& triangles = grown.triangles();
  DisjointSets components = findComponents(tree, triangles);
  std::vector<double> shown(static_cast<std::size_t>(tree.size()));
  for (const GrownTriangle& triangle : triangles) {
    const double area = facing.isKnown()
                            ? facing.shownArea(tree, triangle.corners)
                            : areaFacing(tree, triangle.corners, sensor_origin);
    shown[static_cast<std::size_t>(components.find(triangle.corners[0]))] +=
        grown.isFlipped(triangle) ? -area : area;
  }
  TriangleMesh mesh;
  mesh.triangles.reserve(triangles.size());
  for (const GrownTriangle& triangle : triangles) {
    TriangleMesh::Triangle corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = tree.source(triangle.corners[i]);
    const bool turned =
        shown[static_cast<std::size_t>(components.find(triangle.corners[0]))] < 0;
    if (grown.isFlipped(triangle) != turned)
      std::swap(corners[1], corners[2]);
    mesh.triangles.push_back(corners);
    if (compute_wall_depth)
      mesh.wall_depth.push_back(triangle.depth);
  }
  count(tree, triangles, grown, components, report);
  return mesh;
}

} // namespace pcl::acmap::dewall
