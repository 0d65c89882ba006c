#include "bindings.h"
#include "kernel_call.h"
#include "mesh_argument.h"
#include "named_choice.h"
#include "reports.h"
#include "results.h"
#include "sensors.h"
#include "setter_keyword.h"
#include "surface_picture.h"

#include <pcl/core/impl/mesh_input.h>
#include <pcl/surface/dewall_triangulation.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

constexpr NamedChoices<DeWallRule, 4> dewall_rules = {{{"guarded", DeWallRule::Guarded},
                                                       {"dense", DeWallRule::Dense},
                                                       {"strict", DeWallRule::Strict},
                                                       {"paper", DeWallRule::Guarded}}};

Mesh
triangulate(const PointArgument& points,
            const std::optional<PointArgument>& normals,
            DeWallInput input,
            const DeWallSettings& settings,
            const Listener& listener)
{
  const PointRows rows = pointRowsOf("points", points);
  input.points = rows.view;
  if (normals) {
    input.normals = pointRowsOf("normals", *normals).view;
    requireAsMany("normals", input.normals.size(), rows.view.size());
  }
  DeWallReport report;
  TriangleMesh mesh = callKernel(listener, [&](const Progress& progress) {
    takeSensor(rows.width, !input.sensor_origin.isZero(0), input);
    return triangulateDeWall(input, settings, progress, report);
  });
  Mesh result = pythonMesh(std::move(mesh), reportOf(report));
  result.points = points;
  return result;
}

/** For a notebook: PNG, or None without points. */
py::object
pictureOfMesh(const Mesh& mesh)
{
  if (mesh.points.is_none())
    return py::none();
  const PointView points = pointRowsOf("points", mesh.points).view;
  PictureMesh picture;
  picture.point = [&](std::size_t i) { return points[i]; };
  picture.triangles = mesh.mesh->triangles;
  requireCornersInside(picture.triangles, points.size());
  picture.colors = {{150, 175, 205}};
  const std::string png = pictureOf(picture);
  return png.empty() ? py::object(py::none()) : py::bytes(png);
}

constexpr const char* about_mesh =
    R"(Makes an open, manifold triangle mesh of a point cloud (pcl::DeWallTriangulation, II-C.1
of the paper). Returns a Mesh, whose corners are the points in their order; those of an
(h, w, 3) array count as in points.reshape(-1, 3).

points              (n, 3) or (h, w, 3) float32, metres; read where they are. Points that
                    are not finite, or repeated, are skipped and counted in the report.
maximum_edge_length metres, no edge is longer; 0: automatic, from the spacing around each
                    point. 2.5 voxels suit consolidated points.
rule                'guarded': no point inside the smallest sphere through a triangle;
                    'dense': no such test, covers noisy surfaces better; 'strict': the
                    algorithm as printed in the paper, for comparison, not manifold;
                    'paper': the former name of 'guarded'
normals             as points, unit; off the side from which the points were seen
sensor_origin       metres; faces look there where there are no normals
up                  None, or the direction upwards: no sensor is known then, and faces look to their
                    free space (DeWallTriangulation::setUpDirection)
compute_wall_depth  asks for Mesh.wall_depth
memory_limit        bytes beside the input; 0: none. More raises MemoryError.
threads             0: all; the result is the same bytes for every number
progress            called with (fraction, step); stops the run when it returns False)";

} // namespace

void
bindMesh(py::module_& module)
{
  bindResult<Mesh>(
      module,
      "Mesh",
      "A triangle mesh over points that stand beside it.",
      "triangles report",
      field("triangles",
            &Mesh::triangles,
            "(m, 3) int32, indices of points, counter-clockwise seen from the "
            "side the face looks to"),
      field("wall_depth",
            &Mesh::wall_depth,
            "(m,) uint8, depth of the dividing wall that made a triangle, 255 "
            "for none; None unless asked for"),
      field(
          "points",
          &Mesh::points,
          "the points that the corners index, as they were given to triangulate; None "
          "for a mesh from a file"),
      field("report",
            &Mesh::report,
            "counts, seconds and remarks, named as in pcl::DeWallReport; None "
            "for a mesh from a file"));
  addPicture<Mesh>(module, "Mesh", &pictureOfMesh);
  const DeWallSettings defaults;
  module.def(
      "triangulate",
      [](const PointArgument& points,
         double maximum_edge_length,
         const std::string& rule,
         const std::optional<PointArgument>& normals,
         const std::array<double, 3>& sensor_origin,
         const std::optional<std::array<double, 3>>& up,
         bool compute_wall_depth,
         std::size_t memory_limit,
         unsigned threads,
         const Listener& progress) {
        requireOrigin(sensor_origin);
        DeWallTriangulation<PCLPointCloud2> dewall;
        dewall.setAcceptanceRule(chosen("rule", rule, dewall_rules));
        setKeyword("maximum_edge_length",
                   dewall,
                   &DeWallParameters::setMaximumEdgeLength,
                   maximum_edge_length);
        dewall.setComputeWallDepth(compute_wall_depth);
        dewall.setMemoryLimit(memory_limit);
        if (up)
          dewall.setUpDirection({(*up)[0], (*up)[1], (*up)[2]});
        DeWallInput input;
        input.sensor_origin << sensor_origin[0], sensor_origin[1], sensor_origin[2];
        input.threads = threads;
        return triangulate(points, normals, input, dewall.settings(), progress);
      },
      about_mesh,
      "points"_a,
      py::kw_only(),
      "maximum_edge_length"_a = defaults.maximum_edge_length,
      "rule"_a = nameOf(defaults.rule, dewall_rules),
      "normals"_a = py::none(),
      "sensor_origin"_a = std::array<double, 3>{},
      "up"_a = py::none(),
      "compute_wall_depth"_a = defaults.compute_wall_depth,
      "memory_limit"_a = defaults.memory_limit,
      "threads"_a = 0u,
      "progress"_a = py::none());
}

} // namespace pcl::acmap::python
