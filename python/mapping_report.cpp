#include "mapping_report.h"

#include "rectification_report.h"
#include "reports.h"

namespace pcl::acmap::python {

namespace py = pybind11;

namespace {

using namespace py::literals;

py::object
reportOfMerging(const MergingReport& report)
{
  return reportOf(py::dict("observations"_a = report.observations,
                           "refined"_a = report.refined,
                           "points"_a = report.points,
                           "every"_a = report.every),
                  report);
}

/** Counts that planes in space and planes in a picture have in common. */
template <typename PlaneReport>
py::dict
planeCounts(const PlaneReport& report)
{
  return py::dict("points"_a = report.points,
                  "invalid_points"_a = report.invalid_points,
                  "planes"_a = report.planes,
                  "points_on_planes"_a = report.points_on_planes,
                  "small_regions"_a = report.small_regions,
                  "curved_regions"_a = report.curved_regions,
                  "merged"_a = report.merged,
                  "regular_planes"_a = report.regular_planes,
                  "largest_turn"_a = report.largest_turn);
}

py::object
reportOfPlaneMapping(const PlaneMappingReport& report)
{
  py::dict fields;
  if (report.depth_planes)
    fields = planeCounts(*report.depth_planes);
  else if (report.planes)
    fields = planeCounts(*report.planes);
  fields["voxel_size"] = report.consolidation ? report.consolidation->voxel_size : 0.0;
  return reportOf(fields, report);
}

py::object
reportOfTexture(const TexturingReport& report)
{
  return reportOf(py::dict("observations"_a = report.observations,
                           "pinholes"_a = report.pinholes,
                           "splatted"_a = report.splatted,
                           "invalid_points"_a = report.invalid_points,
                           "charts"_a = report.charts,
                           "texels"_a = report.texels,
                           "seen"_a = report.seen,
                           "filled"_a = report.filled,
                           "texel_size"_a = report.texel_size,
                           "gains"_a = report.gains),
                  report);
}

} // namespace

py::object
reportOfMapping(const CompactMappingReport& report)
{
  py::object rectification = py::none(), outcome = py::none();
  if (report.rectification) {
    rectification =
        reportOfRectification(EntropyRectificationReport(*report.rectification));
    outcome = rectification.attr("outcome");
  }
  return reportOf(py::dict("outcome"_a = outcome,
                           "rectification"_a = rectification,
                           "merging"_a = reportOfMerging(report.merging),
                           "planes"_a = reportOfPlaneMapping(report.planes),
                           "texture"_a = reportOfTexture(report.texture)),
                  report);
}

} // namespace pcl::acmap::python
