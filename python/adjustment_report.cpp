#include "adjustment_report.h"

#include "array_view.h"
#include "named_choice.h"
#include "reports.h"

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

constexpr NamedChoices<AdjustmentOutcome, 4> adjustment_outcomes = {
    {{"adjusted", AdjustmentOutcome::Adjusted},
     {"kept", AdjustmentOutcome::Kept},
     {"refused", AdjustmentOutcome::Refused},
     {"undetermined", AdjustmentOutcome::Undetermined}}};

py::list
roundsOf(const std::vector<AdjustmentRound>& rounds)
{
  py::list all;
  for (const AdjustmentRound& round : rounds)
    all.append(namespaceOf(fieldsOf(round)));
  return all;
}

/** Standard deviations of all poses, as an array that owns them. */
py::array
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

py::object
reportOfAdjustment(PlaneAdjustmentReport&& report)
{
  return reportOf(py::dict("outcome"_a = nameOf(report.outcome, adjustment_outcomes),
                           "reason"_a = report.reason,
                           "views"_a = report.views,
                           "points"_a = report.points,
                           "invalid_points"_a = report.invalid_points,
                           "pieces"_a = report.pieces,
                           "landmarks"_a = report.landmarks,
                           "associated_pieces"_a = report.associated_pieces,
                           "noise_factor"_a = report.noise_factor,
                           "floor"_a = report.floor,
                           "attempts"_a = report.attempts,
                           "odometry_factors"_a = report.odometry_factors,
                           "prior"_a = report.prior,
                           "thickness_before"_a = report.thickness_before,
                           "thickness_after"_a = report.thickness_after,
                           "significance"_a = report.significance,
                           "rays_before"_a = namespaceOf(fieldsOf(report.rays_before)),
                           "rays_after"_a = namespaceOf(fieldsOf(report.rays_after)),
                           "rounds"_a = roundsOf(report.rounds),
                           "position_sd"_a = standardDeviationsOf(
                               report.uncertainty, &PoseUncertainty::position),
                           "rotation_sd"_a = standardDeviationsOf(
                               report.uncertainty, &PoseUncertainty::rotation),
                           "moved"_a = arrayOver(std::move(report.moved)),
                           "turned"_a = arrayOver(std::move(report.turned))),
                  report);
}

} // namespace pcl::acmap::python
