#include "bindings.h"
#include "kernel_call.h"
#include "mesh_argument.h"
#include "named_choice.h"
#include "normals_argument.h"
#include "reports.h"
#include "results.h"
#include "sensors.h"
#include "setter_keyword.h"
#include "surface_picture.h"

#include <pcl/core/polygon_triangles.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

constexpr NamedChoices<SupporterReach, 2> supporter_reaches = {
    {{"members", SupporterReach::Members}, {"hypothesis", SupporterReach::Hypothesis}}};

/** Result of find_planes. */
struct Planes {
  ListOf<PlanePatch> patches;
  py::array_t<std::int32_t> labels;
  std::optional<py::array_t<std::int32_t>> source_labels;
  ReportObject report;
};

/** The points from which the hypotheses were consolidated, and their sensors. */
struct SourceArguments {
  std::optional<PointArgument> points;
  SensorArguments sensors;
};

Planes
findPlanes(const PointArgument& points,
           const NormalsArgument& normals,
           const std::optional<MeshArgument>& triangles,
           const SourceArguments& source,
           const PlaneClusteringSettings& settings,
           const Listener& listener)
{
  PlaneHypotheses hypotheses;
  hypotheses.points = pointRowsOf("points", points).view;
  setNormals(normals, hypotheses);
  if (triangles)
    hypotheses.triangles = meshOf(*triangles, hypotheses.points.size())->triangles;
  PlaneSource raw;
  if (source.points) {
    raw.points = pointRowsOf("source", *source.points).view;
    raw.sensors = sensorViewOf(source.sensors, raw.points.size());
  }
  PlaneClusteringReport report;
  PlaneClusters clusters = callKernel(listener, [&](const Progress& progress) {
    return clusterPlanes(hypotheses, raw, settings, progress, report);
  });
  Planes planes;
  for (PlanePatch& patch : clusters.patches)
    planes.patches.append(py::cast(std::move(patch)));
  planes.labels = arrayOver(std::move(clusters.labels));
  if (source.points)
    planes.source_labels = arrayOver(std::move(clusters.source_labels));
  planes.report = reportOf(report);
  return planes;
}

constexpr const char* about_planes =
    R"(Finds all planes of points with normals (pcl::PlaneHypothesisClustering, II-C.2 of the
paper). Returns Planes.

points          (n, 3) or (h, w, 3) float32, metres; read where they are
normals         Normals of vote_normals, which also tell of creases, or an array as points
triangles       a Mesh or (m, 3) int32: gives outlines, and neighbours if noise_driven
source          as points: the cloud that points were consolidated from; it judges the
                planes if noise_driven
sensor_origin   metres: where the source was seen from; None: unknown
viewpoints      (k, 3) float32, metres: where observations stood, instead
view            int32, for each point of the source which of the viewpoints saw it
noise_driven    the mesh and the noise decide; False: the paper's thresholds, to the letter
member_distance W_d, metres: how near supporters are to others; unless noise_driven
supporter_reach 'members': near to one that supports the plane already; 'hypothesis': near to the
                one that is tested; unless noise_driven
normal_angle    W_n, radians, up to pi / 2
plane_distance  W_t, metres; None: by the noise, or 0.25 unless noise_driven
least_support   W_h: a hypothesis needs more supporters; unless noise_driven
least_area      square metres; if noise_driven; 0: automatic
regular         turns planes to be parallel or upright to larger ones, where their
                uncertainty allows
threads         0: all; the result is the same bytes for every number
progress        called with (fraction, step); stops the run when it returns False)";

/** Of successive planes; neighbours are easily told apart. */
constexpr std::array<std::uint8_t, 3> colors[] = {{86, 140, 200},
                                                  {230, 150, 60},
                                                  {110, 175, 95},
                                                  {205, 95, 95},
                                                  {150, 120, 190},
                                                  {165, 125, 105},
                                                  {225, 140, 190},
                                                  {190, 190, 80},
                                                  {85, 185, 195}};

/** For a notebook: PNG of the outlines, or None without planes. */
py::object
pictureOfPlanes(const Planes& planes)
{
  PictureMesh picture;
  std::vector<Eigen::Vector3f> points;
  std::size_t number = 0;
  for (const py::handle item : planes.patches) {
    const auto& patch = item.cast<const PlanePatch&>();
    const std::array<std::uint8_t, 3> color = colors[number++ % std::size(colors)];
    for (const PlanePolygon& polygon : patch.polygons) {
      const auto first = static_cast<index_t>(points.size());
      for (const TriangleMesh::Triangle& corners :
           trianglesOfPolygon(polygon, patch.coefficients.head<3>())) {
        picture.triangles.push_back(
            {corners[0] + first, corners[1] + first, corners[2] + first});
        picture.colors.push_back(color);
      }
      for (const Eigen::Vector3f& point : pointsOfPolygon(polygon))
        points.push_back(point);
    }
  }
  picture.point = [&](std::size_t i) { return points[i]; };
  const std::string png = pictureOf(picture);
  return png.empty() ? py::object(py::none()) : py::bytes(png);
}

void
bindPlanesClass(py::module_& module)
{
  bindResult<Planes>(
      module,
      "Planes",
      "What find_planes found.",
      "patches labels source_labels report",
      field("patches",
            &Planes::patches,
            "list of PlanePatch, by falling area, or as grown without a mesh"),
      field("labels",
            &Planes::labels,
            "(n,) int32, for each point its patch, -1 for none"),
      field("source_labels",
            &Planes::source_labels,
            "the same for each point of the source; None without one"),
      field("report",
            &Planes::report,
            "counts, seconds and remarks, named as in "
            "pcl::PlaneClusteringReport"));
  addPicture<Planes>(module, "Planes", &pictureOfPlanes);
}

} // namespace

void
bindPlanes(py::module_& module)
{
  bindPlanesClass(module);
  const PlaneClusteringSettings defaults;
  module.def(
      "find_planes",
      [](const PointArgument& points,
         const NormalsArgument& normals,
         const std::optional<MeshArgument>& triangles,
         std::optional<PointArgument> source,
         std::optional<std::array<double, 3>> sensor_origin,
         std::optional<PointArgument> viewpoints,
         std::optional<IndexArgument> view,
         bool noise_driven,
         double member_distance,
         const std::string& supporter_reach,
         double normal_angle,
         std::optional<double> plane_distance,
         std::size_t min_support,
         double min_area,
         bool regular,
         unsigned threads,
         const Listener& progress) {
        using Clustering = PlaneClusteringParameters;
        PlaneHypothesisClustering<PCLPointCloud2> clustering;
        clustering.setNoiseDriven(noise_driven);
        setKeyword("member_distance",
                   clustering,
                   &Clustering::setClusterTolerance,
                   member_distance);
        setKeyword("normal_angle",
                   clustering,
                   &Clustering::setSmoothnessThreshold,
                   normal_angle);
        setKeyword("plane_distance",
                   clustering,
                   &Clustering::setDistanceThreshold,
                   plane_distance);
        clustering.setSupporterReach(
            chosen("supporter_reach", supporter_reach, supporter_reaches));
        clustering.setMinClusterSize(min_support);
        setKeyword("least_area", clustering, &Clustering::setMinArea, min_area);
        clustering.setRegularize(regular);
        clustering.setNumberOfThreads(threads);
        return findPlanes(points,
                          normals,
                          triangles,
                          {std::move(source),
                           {sensor_origin, std::move(viewpoints), std::move(view)}},
                          clustering.settings(),
                          progress);
      },
      about_planes,
      "points"_a,
      "normals"_a,
      "triangles"_a = py::none(),
      py::kw_only(),
      "source"_a = py::none(),
      "sensor_origin"_a = std::array<double, 3>{},
      "viewpoints"_a = py::none(),
      "view"_a = py::none(),
      "noise_driven"_a = defaults.noise_driven,
      "member_distance"_a = defaults.member_distance,
      "supporter_reach"_a = nameOf(defaults.reach, supporter_reaches),
      "normal_angle"_a = defaults.normal_angle,
      "plane_distance"_a = py::none(),
      "least_support"_a = defaults.min_support,
      "least_area"_a = defaults.min_area,
      "regular"_a = defaults.regular,
      "threads"_a = defaults.threads,
      "progress"_a = py::none());
}

} // namespace pcl::acmap::python
