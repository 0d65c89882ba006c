#include "adjustment_report.h"

#include "array_view.h"
#include "reports.h"

namespace pcl::acmap::python {

namespace {

/** Standard deviations of all poses, as an array that owns them. */
py::array_t<double>
standardDeviationsOf(const std::vector<PoseUncertainty>& poses,
                     double PoseUncertainty::*deviation)
{
  std::vector<double> values;
  values.reserve(poses.size());
  for (const PoseUncertainty& pose : poses)
    values.push_back(pose.*deviation);
  return arrayOver(std::move(values));
}

} // namespace

ReportObject
reportOfAdjustment(const PlaneAdjustmentReport& report)
{
  py::dict fields = fieldsOf(report);
  fields.attr("pop")("uncertainty");
  fields["position_sd"] =
      standardDeviationsOf(report.uncertainty, &PoseUncertainty::position);
  fields["rotation_sd"] =
      standardDeviationsOf(report.uncertainty, &PoseUncertainty::rotation);
  return reportOf(fields, report);
}

} // namespace pcl::acmap::python
