#include "mesh_checker.h"

#include "face_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <ostream>
#include <set>

namespace pcl::acmap::test {
namespace {

bool
isValid(const Points& points, const Triangle& face)
{
  return std::all_of(face.begin(), face.end(), [&](std::int32_t corner) {
    return corner >= 0 && static_cast<std::size_t>(corner) < points.size() &&
           points[corner].allFinite();
  });
}

bool
hasRepeatedCorner(const Triangle& face)
{
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/** The faces whose topology can be checked. */
Triangles
usableFaces(const Points& points, const Triangles& faces)
{
  Triangles usable;
  std::copy_if(faces.begin(),
               faces.end(),
               std::back_inserter(usable),
               [&](const Triangle& face) {
                 return isValid(points, face) && !hasRepeatedCorner(face);
               });
  return usable;
}

std::size_t
countDuplicates(const Triangles& faces)
{
  std::set<Triangle> seen;
  std::size_t duplicates = 0;
  for (Triangle face : faces) {
    std::sort(face.begin(), face.end());
    duplicates += seen.insert(face).second ? 0 : 1;
  }
  return duplicates;
}

/** Counts faults at the edges; marks the vertices of crowded edges. */
void
checkEdges(const Triangles& faces,
           const MeshDemands& demands,
           MeshFaults& faults,
           std::vector<char>& is_torn)
{
  for (const auto& [edge, uses] : edgesOf(faces)) {
    if (uses.size() > 2) {
      ++faults.crowded_edges;
      is_torn[edge.first] = is_torn[edge.second] = 1;
    }
    faults.inconsistent_edges += uses.size() == 2 && uses[0].forward == uses[1].forward;
    faults.forbidden_edges +=
        demands.edge_allowed && !demands.edge_allowed(edge.first, edge.second);
  }
}

void
checkVertices(const Triangles& faces,
              MeshFaults& faults,
              const std::vector<char>& is_torn)
{
  const auto around = facesAroundVertices(faces, is_torn.size());
  for (std::size_t vertex = 0; vertex < is_torn.size(); ++vertex)
    faults.torn_vertices +=
        is_torn[vertex] ||
        countFans(faces, around[vertex], static_cast<std::int32_t>(vertex)) > 1;
}

bool
isOccupied(const Points& points,
           const ReferenceTree& tree,
           const Triangle& face,
           double tolerance)
{
  const SmallestSphere sphere =
      smallestCircumsphere(points[face[0]], points[face[1]], points[face[2]]);
  return !std::isfinite(sphere.radius) ||
         tree.findWithin(sphere.center, sphere.radius * (1 - tolerance)) >= 0;
}

} // namespace

EdgeAllowed
noLongerThan(const Points& points, double length)
{
  const double squared = length * length * (1 + 1e-12);
  return [&points, squared](std::int32_t a, std::int32_t b) {
    return (points[a] - points[b]).squaredNorm() <= squared;
  };
}

std::size_t
MeshFaults::total() const
{
  return invalid_faces + degenerate_faces + duplicate_faces + crowded_edges +
         torn_vertices + inconsistent_edges + forbidden_edges + occupied_spheres;
}

std::ostream&
operator<<(std::ostream& stream, const MeshFaults& faults)
{
  return stream << "invalid " << faults.invalid_faces << ", degenerate "
                << faults.degenerate_faces << ", duplicate " << faults.duplicate_faces
                << ", crowded edges " << faults.crowded_edges << ", torn vertices "
                << faults.torn_vertices << ", inconsistent edges "
                << faults.inconsistent_edges << ", forbidden edges "
                << faults.forbidden_edges << ", occupied spheres "
                << faults.occupied_spheres;
}

MeshFaults
checkMesh(const Points& points, const Triangles& faces, const MeshDemands& demands)
{
  MeshFaults faults;
  for (const Triangle& face : faces) {
    if (!isValid(points, face))
      ++faults.invalid_faces;
    else if (hasRepeatedCorner(face) ||
             areaRatio(points[face[0]], points[face[1]], points[face[2]]) <
                 demands.min_area_ratio)
      ++faults.degenerate_faces;
  }
  const Triangles usable = usableFaces(points, faces);
  faults.duplicate_faces = countDuplicates(usable);
  std::vector<char> is_torn(points.size(), 0);
  checkEdges(usable, demands, faults, is_torn);
  checkVertices(usable, faults, is_torn);
  if (demands.empty_spheres) {
    const ReferenceTree tree(points);
    faults.occupied_spheres = static_cast<std::size_t>(
        std::count_if(usable.begin(), usable.end(), [&](const Triangle& face) {
          return isOccupied(points, tree, face, demands.sphere_tolerance);
        }));
  }
  return faults;
}

MeshCounts
countMesh(const Points& points, const Triangles& faces)
{
  const Triangles usable = usableFaces(points, faces);
  MeshCounts counts;
  counts.faces = usable.size();
  std::vector<char> used(points.size(), 0);
  for (const Triangle& face : usable)
    for (const std::int32_t corner : face)
      used[corner] = 1;
  counts.used_points =
      static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));

  const auto edges = edgesOf(usable);
  FaceSets components(usable.size());
  FaceSets loops(points.size());
  std::vector<char> on_boundary(points.size(), 0);
  for (const auto& [edge, uses] : edges) {
    for (const EdgeUse& use : uses)
      components.unite(uses.front().face, use.face);
    if (uses.size() == 1) {
      ++counts.boundary_edges;
      loops.unite(edge.first, edge.second);
      on_boundary[edge.first] = on_boundary[edge.second] = 1;
    }
  }
  counts.edges = edges.size();
  for (std::size_t face = 0; face < usable.size(); ++face)
    counts.components += components.find(face) == face;
  for (std::size_t point = 0; point < points.size(); ++point)
    counts.boundary_loops += on_boundary[point] && loops.find(point) == point;
  return counts;
}

SmallestSphere
smallestCircumsphere(const Eigen::Vector3d& a,
                     const Eigen::Vector3d& b,
                     const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const Eigen::Vector3d normal = u.cross(v);
  const double denominator = 2 * normal.squaredNorm();
  if (!(denominator > 0))
    return {};
  const Eigen::Vector3d offset =
      (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) /
      denominator;
  return {a + offset, offset.norm()};
}

double
areaRatio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

Triangles
toTriangles(const std::vector<Vertices>& polygons)
{
  Triangles faces;
  for (const Vertices& polygon : polygons)
    for (std::size_t i = 2; i < polygon.vertices.size(); ++i)
      faces.push_back({static_cast<std::int32_t>(polygon.vertices[0]),
                       static_cast<std::int32_t>(polygon.vertices[i - 1]),
                       static_cast<std::int32_t>(polygon.vertices[i])});
  return faces;
}

} // namespace pcl::acmap::test
