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

py::list
stepsOf(const std::vector<RectificationStep>& steps)
{
  py::list all;
  for (const RectificationStep& step : steps)
    all.append(namespaceOf(fieldsOf(step)));
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
                           "before"_a = namespaceOf(fieldsOf(report.before)),
                           "after"_a = namespaceOf(fieldsOf(report.after)),
                           "moved"_a = arrayOver(std::move(report.moved)),
                           "turned"_a = arrayOver(std::move(report.turned))),
                  report);
}

} // namespace pcl::acmap::python
