#include "mesh_argument.h"

#include <pcl/core/impl/mesh_input.h>

namespace pcl::acmap::python {

Mesh
pythonMesh(TriangleMesh&& mesh, py::object report)
{
  Mesh result;
  result.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
  const auto owner = owned(std::shared_ptr<TriangleMesh>(result.mesh)).second;
  result.triangles = fieldOf<std::int32_t>(
      result.mesh->triangles, 3, owner, [](const TriangleMesh::Triangle& triangle) {
        return triangle.data();
      });
  result.wall_depth = py::none();
  if (!result.mesh->wall_depth.empty())
    result.wall_depth = fieldOf<std::uint8_t>(
        result.mesh->wall_depth, 0, owner, [](const std::uint8_t& depth) {
          return &depth;
        });
  result.report = std::move(report);
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
    const std::string shape = "(m, 3)";
    const py::array array =
        arrayOf("triangles", argument, py::dtype::of<std::int32_t>(), {2}, shape);
    const py::array_t<std::int32_t> corners(array);
    if (corners.shape(1) != 3)
      refuseShape("triangles", array, shape);
    mesh = std::make_shared<TriangleMesh>();
    const auto at = corners.unchecked<2>();
    for (py::ssize_t t = 0; t < at.shape(0); ++t)
      mesh->triangles.push_back({at(t, 0), at(t, 1), at(t, 2)});
  }
  requireCornersInside(mesh->triangles, points);
  return mesh;
}

} // namespace pcl::acmap::python
