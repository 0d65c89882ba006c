#include "mapping_report.h"

#include "adjustment_report.h"
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

py::object
reportOfPlaneMapping(const PlaneMappingReport& report)
{
  py::dict fields;
  if (report.depth_planes)
    fields = fieldsOf(*report.depth_planes);
  else if (report.planes)
    fields = fieldsOf(*report.planes);
  fields["consolidated_points"] = report.consolidated_points;
  fields["voxel_size"] = report.consolidation ? report.consolidation->voxel_size : 0.0;
  if (report.cylinders)
    fields["cylinders"] = reportOf(*report.cylinders);
  if (report.boxes)
    fields["boxes"] = reportOf(*report.boxes);
  if (report.recesses)
    fields["recesses"] = reportOf(*report.recesses);
  return reportOf(fields, report);
}

} // namespace

py::object
reportOfMapping(const CompactMappingReport& report)
{
  py::object rectification = py::none(), adjustment = py::none(), outcome = py::none();
  if (report.rectification) {
    rectification =
        reportOfRectification(EntropyRectificationReport(*report.rectification));
    outcome = rectification.attr("outcome");
  }
  if (report.adjustment)
    adjustment = reportOfAdjustment(PlaneAdjustmentReport(*report.adjustment));
  const bool is_paper = report.mode == MappingMode::Paper;
  return reportOf(py::dict("mode"_a = is_paper ? "paper" : "accurate",
                           "outcome"_a = outcome,
                           "rectification"_a = rectification,
                           "adjustment"_a = adjustment,
                           "merging"_a = reportOfMerging(report.merging),
                           "planes"_a = reportOfPlaneMapping(report.planes),
                           "texture"_a = reportOf(report.texture)),
                  report);
}

} // namespace pcl::acmap::python
