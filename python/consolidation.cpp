#include "bindings.h"
#include "kernel_call.h"
#include "reports.h"
#include "results.h"
#include "sensors.h"
#include "setter_keyword.h"

#include <pcl/filters/voxel_consolidation.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

/** Result of consolidate: arrays that refer to one Consolidation. */
struct Consolidated {
  py::array_t<float> points, normals, curvature;
  py::array_t<std::int32_t> witness;
  std::optional<py::array_t<std::int32_t>> representative_of;
  ReportObject report;
};

Consolidated
arraysOf(Consolidation&& result, bool keep_sources, const ConsolidationReport& report)
{
  Consolidated arrays;
  const auto [all, owner] = owned(std::move(result.representatives));
  arrays.points = fieldOf<float>(
      all, 3, owner, [](const Representative& one) { return one.point.data(); });
  arrays.normals = fieldOf<float>(
      all, 3, owner, [](const Representative& one) { return one.normal.data(); });
  arrays.curvature = fieldOf<float>(
      all, 0, owner, [](const Representative& one) { return &one.curvature; });
  arrays.witness = fieldOf<std::int32_t>(
      all, 0, owner, [](const Representative& one) { return &one.witness; });
  if (keep_sources)
    arrays.representative_of = arrayOver(std::move(result.representative_of));
  arrays.report = reportOf(report);
  return arrays;
}

Consolidated
consolidate(const PointArgument& points,
            const ConsolidationSettings& settings,
            const SensorArguments& sensors,
            const Listener& listener)
{
  const PointView view = pointRowsOf("points", points).view;
  const SensorView seen_by = sensorViewOf(sensors, view.size());
  ConsolidationReport report;
  Consolidation result = callKernel(listener, [&](const Progress& progress) {
    return consolidatePoints(view, seen_by, {}, settings, progress, report);
  });
  return arraysOf(std::move(result), settings.keep_sources, report);
}

constexpr const char* about_consolidation =
    R"(Brings a noisy cloud of surfaces to its noise scale: one point a voxel, on the plane of
the points around it (pcl::VoxelConsolidation). Returns a Consolidated.

points        (n, 3) or (h, w, 3) float32, metres; read where they are. Points that are
              not finite are skipped and counted in the report.
voxel_size    metres, the edge of a voxel; 0: automatic, from noise and spacing
sensor_origin where all points were seen from, metres; None: unknown. Normals look there.
viewpoints    (k, 3) float32, metres: where observations stood, instead of sensor_origin
view          int32, for each point which of the viewpoints saw it
keep_sources  asks for Consolidated.representative_of
threads       0: all; the result is the same bytes for every number
progress      called with (fraction, step); stops the run when it returns False)";

} // namespace

void
bindConsolidation(py::module_& module)
{
  bindResult<Consolidated>(
      module,
      "Consolidated",
      "What consolidate found: k points.",
      "points report",
      field("points", &Consolidated::points, "(k, 3) float32, metres"),
      field("normals",
            &Consolidated::normals,
            "(k, 3) float32, unit, towards the sensor; NaN without a plane"),
      field("curvature",
            &Consolidated::curvature,
            "(k,) float32, least variance over the sum of all three around a point"),
      field("witness",
            &Consolidated::witness,
            "(k,) int32, the input point that was seen from nearest: use it to "
            "pick colours and views"),
      field("representative_of",
            &Consolidated::representative_of,
            "(n,) int32, for each input point its point here, -1 without one; "
            "None unless asked for"),
      field("report",
            &Consolidated::report,
            "counts, seconds and remarks, named as in pcl::ConsolidationReport"));
  const ConsolidationSettings defaults;
  module.def(
      "consolidate",
      [](const PointArgument& points,
         double voxel_size,
         std::optional<std::array<double, 3>> sensor_origin,
         std::optional<PointArgument> viewpoints,
         std::optional<IndexArgument> view,
         bool keep_sources,
         unsigned threads,
         const Listener& progress) {
        VoxelConsolidation<PCLPointCloud2> consolidation;
        setKeyword("voxel_size",
                   consolidation,
                   &ConsolidationParameters::setVoxelSize,
                   voxel_size);
        consolidation.setKeepSources(keep_sources);
        consolidation.setNumberOfThreads(threads);
        return consolidate(points,
                           consolidation.settings(),
                           {sensor_origin, std::move(viewpoints), std::move(view)},
                           progress);
      },
      about_consolidation,
      "points"_a,
      py::kw_only(),
      "voxel_size"_a = defaults.voxel_size,
      "sensor_origin"_a = std::array<double, 3>{},
      "viewpoints"_a = py::none(),
      "view"_a = py::none(),
      "keep_sources"_a = defaults.keep_sources,
      "threads"_a = defaults.threads,
      "progress"_a = py::none());
}

} // namespace pcl::acmap::python
