#include "rectification_report.h"

#include "array_view.h"
#include "named_choice.h"
#include "reports.h"

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

constexpr NamedChoices<RectificationOutcome, 4> outcomes = {
    {{"rectified", RectificationOutcome::Rectified},
     {"kept", RectificationOutcome::Kept},
     {"refused", RectificationOutcome::Refused},
     {"undetermined", RectificationOutcome::Undetermined}}};

py::object
simple(const py::dict& fields)
{
  return py::module_::import("types").attr("SimpleNamespace")(**fields);
}

py::object
evidenceOf(const MapEvidence& evidence)
{
  return simple(py::dict("rays"_a = evidence.rays,
                         "near_contradictions"_a = evidence.near_contradictions,
                         "far_contradictions"_a = evidence.far_contradictions,
                         "near_rays"_a = evidence.near_rays,
                         "far_rays"_a = evidence.far_rays,
                         "pair_contradictions"_a = evidence.pair_contradictions,
                         "contradicted_pairs"_a = evidence.contradicted_pairs,
                         "mean_map_entropy"_a = evidence.mean_map_entropy,
                         "orthogonal_variance"_a = evidence.orthogonal_variance));
}

py::list
stepsOf(const std::vector<RectificationStep>& steps)
{
  py::list all;
  for (const RectificationStep& step : steps)
    all.append(simple(py::dict("search"_a = step.search,
                               "bin_size"_a = step.bin_size,
                               "entropy"_a = step.entropy,
                               "prior"_a = step.prior,
                               "energy"_a = step.energy)));
  return all;
}

} // namespace

py::object
reportOfRectification(EntropyRectificationReport&& report)
{
  return reportOf(py::dict("outcome"_a = nameOf(report.outcome, outcomes),
                           "reason"_a = report.reason,
                           "observations"_a = report.observations,
                           "points"_a = report.points,
                           "invalid_points"_a = report.invalid_points,
                           "evaluations"_a = report.evaluations,
                           "votes"_a = report.votes,
                           "accepted_moves"_a = report.accepted_moves,
                           "odometry_scale"_a = report.odometry_scale,
                           "strongest_action"_a = report.strongest_action,
                           "disagreement"_a = report.disagreement,
                           "steps"_a = stepsOf(report.steps),
                           "before"_a = evidenceOf(report.before),
                           "after"_a = evidenceOf(report.after),
                           "moved"_a = arrayOver(std::move(report.moved)),
                           "turned"_a = arrayOver(std::move(report.turned))),
                  report);
}

} // namespace pcl::acmap::python
