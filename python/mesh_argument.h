#pragma once

#include "array_view.h"

#include <pcl/core/triangle_mesh.h>

#include <memory>
#include <optional>

namespace pcl::acmap::python {

struct ShownPointsOrNone {
  static constexpr auto name =
      py::detail::const_name("Optional[numpy.ndarray[float32[n, 3]]]");
};

using PointsOrNone = ShownAs<ShownPointsOrNone>;

/** \brief Result of triangulate. Its arrays refer to the mesh. */
struct Mesh {
  std::shared_ptr<TriangleMesh> mesh;
  py::array_t<std::int32_t> triangles;
  std::optional<py::array_t<std::uint8_t>> wall_depth;
  PointsOrNone points = py::none();
  ReportOrNone report;
};

struct ShownMesh {
  static constexpr auto name =
      py::detail::const_name("Union[acmap.Mesh, numpy.ndarray[int32[m, 3]]]");
};

/** \brief A Mesh, or an array; checked by \ref meshOf. */
using MeshArgument = ShownAs<ShownMesh>;

/** \brief Creates a Mesh with arrays that refer to it. */
Mesh
pythonMesh(TriangleMesh&& mesh, ReportOrNone report);

/** \brief Completes what was unpickled. \throws py::value_error if it does not fit */
Mesh
restored(const Mesh& read);

/** \brief The triangles of an argument: those of a Mesh without a copy, those of an
 * array, (m, 3) int32, as a copy.
 * \throws py::type_error, py::value_error when it is neither
 * \throws InitFailedException when an index is not less than \a points */
std::shared_ptr<const TriangleMesh>
meshOf(const MeshArgument& argument, std::size_t points);

} // namespace pcl::acmap::python
