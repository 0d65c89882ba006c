#include "mapping_report.h"

#include "adjustment_report.h"
#include "reports.h"

namespace pcl::acmap::python {

namespace {

/** The fields of the step that found the planes are among those of the report, whose
 * field `planes` is their number. */
ReportObject
reportOfPlaneMapping(const PlaneMappingReport& report)
{
  py::dict fields = fieldsOf(report);
  const auto join = [&fields](const auto& step) {
    if (step)
      fields.attr("update")(fieldsOf(*step));
  };
  join(report.depth_planes);
  join(report.planes);
  fields["voxel_size"] = report.consolidation ? report.consolidation->voxel_size : 0.0;
  return reportOf(fields, report);
}

} // namespace

ReportObject
reportOfMapping(const CompactMappingReport& report)
{
  py::dict fields = fieldsOf(report);
  fields["outcome"] = py::none();
  if (report.rectification)
    fields["outcome"] = fields["rectification"].attr("outcome");
  if (report.adjustment)
    fields["adjustment"] = reportOfAdjustment(*report.adjustment);
  fields["planes"] = reportOfPlaneMapping(report.planes);
  return reportOf(fields, report);
}

} // namespace pcl::acmap::python
