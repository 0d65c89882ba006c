#include "mesh_argument.h"

#include <pcl/core/impl/mesh_input.h>

namespace pcl::acmap::python {

namespace {

TriangleMesh::Triangles
trianglesOf(const py::handle& argument)
{
  const std::string shape = "(m, 3)";
  const py::array array =
      arrayOf("triangles", argument, py::dtype::of<std::int32_t>(), {2}, shape);
  if (array.shape(1) != 3)
    refuseShape("triangles", array, shape);
  TriangleMesh::Triangles triangles;
  const auto at = array.unchecked<std::int32_t, 2>();
  for (py::ssize_t t = 0; t < at.shape(0); ++t)
    triangles.push_back({at(t, 0), at(t, 1), at(t, 2)});
  return triangles;
}

} // namespace

Mesh
pythonMesh(TriangleMesh&& mesh, ReportOrNone report)
{
  Mesh result;
  result.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
  const auto owner = owned(std::shared_ptr<TriangleMesh>(result.mesh)).second;
  result.triangles = fieldOf<std::int32_t>(
      result.mesh->triangles, 3, owner, [](const TriangleMesh::Triangle& triangle) {
        return triangle.data();
      });
  if (!result.mesh->wall_depth.empty())
    result.wall_depth = fieldOf<std::uint8_t>(
        result.mesh->wall_depth, 0, owner, [](const std::uint8_t& depth) {
          return &depth;
        });
  result.report = std::move(report);
  return result;
}

Mesh
restored(const Mesh& read)
{
  TriangleMesh mesh;
  mesh.triangles = trianglesOf(read.triangles);
  if (read.wall_depth) {
    const auto depth = read.wall_depth->unchecked<1>();
    requireAsMany(
        "wall_depth", static_cast<std::size_t>(depth.size()), mesh.triangles.size());
    for (py::ssize_t t = 0; t < depth.size(); ++t)
      mesh.wall_depth.push_back(depth(t));
  }
  Mesh result = pythonMesh(std::move(mesh), read.report);
  result.points = read.points;
  return result;
}

std::shared_ptr<const TriangleMesh>
meshOf(const MeshArgument& argument, std::size_t points)
{
  std::shared_ptr<TriangleMesh> mesh;
  if (py::isinstance<Mesh>(argument)) {
    mesh = argument.cast<const Mesh&>().mesh;
  }
  else {
    mesh = std::make_shared<TriangleMesh>();
    mesh->triangles = trianglesOf(argument);
  }
  requireCornersInside(mesh->triangles, points);
  return mesh;
}

} // namespace pcl::acmap::python
