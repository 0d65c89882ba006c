#include "bindings.h"
#include "kernel_call.h"
#include "mesh_argument.h"
#include "normals_argument.h"
#include "reports.h"
#include "results.h"
#include "sensors.h"
#include "setter_keyword.h"

#include <pcl/features/normal_vector_voting.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

Normals
voteOnMesh(const PointArgument& points,
           const MeshArgument& triangles,
           const VotingSettings& settings,
           const SensorArguments& sensors,
           const Listener& listener)
{
  const PointView view = pointRowsOf("points", points).view;
  const std::shared_ptr<const TriangleMesh> mesh = meshOf(triangles, view.size());
  const SensorView seen_by = sensorViewOf(sensors, view.size());
  VotingReport report;
  VotedNormals votes = callKernel(listener, [&](const Progress& progress) {
    return voteNormals(view, mesh->triangles, seen_by, settings, progress, report);
  });
  return pythonNormals(std::move(votes), settings.compute_curvatures, reportOf(report));
}

constexpr const char* about_normals =
    R"(Votes for the normals at the vertices of a mesh, and tells creases and corners from
surfaces (pcl::NormalVectorVoting, II-C.2 of the paper). Returns Normals.

points             (n, 3) or (h, w, 3) float32, metres: the vertices; read where they are
triangles          a Mesh, read where it is, or an array of index triples, copied
radius             metres along the surface, how far votes come from; 0: automatic
crease_weight      eps: how much a crease counts against a surface; None: 12, with paper 2
corner_weight      eta: how much a corner counts against a crease; None: 0.3, with paper 2
paper              the weights of Page et al. as they are, without ours
sensor_origin      metres, where normals look; None: where the faces look
viewpoints         (k, 3) float32, metres: where observations stood, instead
view               int32, for each point which of the viewpoints saw it
compute_curvatures asks for Normals.curvatures and Normals.curvature_directions
threads            0: all; the result is the same bytes for every number
progress           called with (fraction, step); stops the run when it returns False)";

void
bindNormalsClass(py::module_& module)
{
  bindResult<Normals>(
      module,
      "Normals",
      "What vote_normals found at n vertices.",
      "normals curvatures report",
      field("normals",
            &Normals::normals,
            "(n, 3) float32, unit; NaN where less than three triangles vote"),
      field(
          "directions", &Normals::directions, "(n, 3) float32, unit, along the crease"),
      field("saliency",
            &Normals::saliency,
            "(n,) float32, 1 on a plane; 1 - saliency is PCL's curvature"),
      field("vertex_class",
            &Normals::vertex_class,
            "(n,) uint8: 0 unknown, 1 surface, 2 crease, 3 corner"),
      field("curvatures",
            &Normals::curvatures,
            "(n, 2) float32, 1/m, the larger by magnitude first; None unless "
            "asked for"),
      field("curvature_directions",
            &Normals::curvature_directions,
            "(n, 3) float32, unit, of the first curvature; None unless asked for"),
      field("report",
            &Normals::report,
            "counts, seconds and remarks, named as in pcl::VotingReport"));
}

} // namespace

void
bindNormals(py::module_& module)
{
  bindNormalsClass(module);
  const VotingSettings defaults;
  module.def(
      "vote_normals",
      [](const PointArgument& points,
         const MeshArgument& triangles,
         double radius,
         std::optional<double> crease_weight,
         std::optional<double> corner_weight,
         bool paper,
         std::optional<std::array<double, 3>> sensor_origin,
         std::optional<PointArgument> viewpoints,
         std::optional<IndexArgument> view,
         bool compute_curvatures,
         unsigned threads,
         const Listener& progress) {
        NormalVectorVoting<PCLPointCloud2> voting;
        setKeyword("radius", voting, &VotingParameters::setRadiusSearch, radius);
        setKeyword(
            "crease_weight", voting, &VotingParameters::setCreaseWeight, crease_weight);
        setKeyword(
            "corner_weight", voting, &VotingParameters::setCornerWeight, corner_weight);
        voting.setPaperMode(paper);
        voting.setNumberOfThreads(threads);
        VotingSettings settings = voting.settings();
        settings.compute_curvatures = compute_curvatures;
        return voteOnMesh(points,
                          triangles,
                          settings,
                          {sensor_origin, std::move(viewpoints), std::move(view)},
                          progress);
      },
      about_normals,
      "points"_a,
      "triangles"_a,
      py::kw_only(),
      "radius"_a = defaults.radius,
      "crease_weight"_a = py::none(),
      "corner_weight"_a = py::none(),
      "paper"_a = defaults.paper,
      "sensor_origin"_a = py::none(),
      "viewpoints"_a = py::none(),
      "view"_a = py::none(),
      "compute_curvatures"_a = defaults.compute_curvatures,
      "threads"_a = defaults.threads,
      "progress"_a = py::none());
}

} // namespace pcl::acmap::python
