#include "adjustment_report.h"
#include "bindings.h"
#include "kernel_call.h"
#include "poses.h"
#include "results.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

/** Result of adjust. */
struct Adjusted {
  py::array_t<double> poses;
  ReportObject report;
};

std::vector<AdjustedView>
viewsOf(const std::vector<PointArgument>& clouds,
        const std::optional<std::vector<WeightArgument>>& sigmas)
{
  if (sigmas && sigmas->size() != clouds.size())
    throw py::value_error("sigmas: there are " + std::to_string(sigmas->size()) +
                          " for " + std::to_string(clouds.size()) + " clouds");
  std::vector<AdjustedView> views(clouds.size());
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    const PointRows rows = pointRowsOf("clouds" + place, clouds[i]);
    views[i].points = rows.view;
    views[i].width = rows.width;
    if (!sigmas)
      continue;
    const Column column = columnOf(
        "sigmas" + place, (*sigmas)[i], py::dtype::of<float>(), rows.view.size());
    views[i].sigmas = static_cast<const float*>(column.first);
    views[i].sigma_stride = column.stride;
  }
  return views;
}

Adjusted
adjustClouds(const std::vector<PointArgument>& clouds,
             const PoseArgument& poses,
             const std::optional<std::vector<WeightArgument>>& sigmas,
             const PlaneAdjustmentSettings& settings,
             unsigned threads,
             const Listener& listener)
{
  requireOdometryNoise(settings.odometry);
  const std::vector<AdjustedView> views = viewsOf(clouds, sigmas);
  const Poses given = posesOf("poses", poses);
  if (given.size() != views.size())
    throw py::value_error("poses: there are " + std::to_string(given.size()) + " for " +
                          std::to_string(views.size()) + " clouds");
  if (given.empty())
    throw py::value_error("clouds: there is none");
  PlaneAdjustmentReport report;
  const AdjustedViewReader read =
      [&views](std::size_t i, const std::function<void(const AdjustedView&)>& use) {
        use(views[i]);
      };
  const auto [found, owner] = owned(callKernel(listener, [&](const Progress& progress) {
    Poses adjusted;
    withThreads(threads, [&] {
      adjusted = adjustPlanes(read, given, settings, progress, report);
    });
    return adjusted;
  }));
  return {arrayOfPoses(found, owner), reportOfAdjustment(report)};
}

constexpr const char* about_adjustment =
    R"(Adjusts the poses of all views at once, in six degrees of freedom, so that planes which
several views see become thin (pcl::PlaneAdjustment). Returns an Adjusted.

clouds            a list of (n, 3) or (h, w, 3) float32, metres, each in its sensor's frame,
                  as measured, in the order in which they were made
poses             (k, 4, 4) float64: T_map_camera of each; the first one stays
sigmas            a list of (n,) or (h, w) float32: standard deviation of each point along
                  its ray, metres; None: measured
odometry_length, odometry_length_per_metre, odometry_turn, odometry_turn_per_radian
                  what the odometry is expected to err by, one standard deviation: metres,
                  m/m, radians, rad/rad
estimate_odometry rescales these by the residuals
threads           0: all; the result is the same bytes for every number
progress          called with (fraction, step); stops the run when it returns False)";

} // namespace

void
bindAdjustment(py::module_& module)
{
  bindResult<Adjusted>(
      module,
      "Adjusted",
      "What adjust found.",
      "poses report",
      field("poses",
            &Adjusted::poses,
            "(k, 4, 4) float64, T_map_camera; as they came unless "
            "report.outcome is 'adjusted'"),
      field("report",
            &Adjusted::report,
            "outcome, its reason, evidence, seconds and remarks, named as in "
            "pcl::PlaneAdjustmentReport; uncertainty as the arrays position_sd "
            "and rotation_sd"));
  const PlaneAdjustmentSettings defaults;
  module.def(
      "adjust",
      [](const std::vector<PointArgument>& clouds,
         const PoseArgument& poses,
         const std::optional<std::vector<WeightArgument>>& sigmas,
         double odometry_length,
         double odometry_length_per_metre,
         double odometry_turn,
         double odometry_turn_per_radian,
         bool estimate_odometry,
         unsigned threads,
         const Listener& progress) {
        PlaneAdjustmentSettings settings;
        settings.odometry = {odometry_length,
                             odometry_length_per_metre,
                             odometry_turn,
                             odometry_turn_per_radian};
        settings.estimate_odometry = estimate_odometry;
        return adjustClouds(clouds, poses, sigmas, settings, threads, progress);
      },
      about_adjustment,
      "clouds"_a,
      "poses"_a,
      py::kw_only(),
      "sigmas"_a = py::none(),
      "odometry_length"_a = defaults.odometry.length,
      "odometry_length_per_metre"_a = defaults.odometry.length_per_metre,
      "odometry_turn"_a = defaults.odometry.turn,
      "odometry_turn_per_radian"_a = defaults.odometry.turn_per_radian,
      "estimate_odometry"_a = defaults.estimate_odometry,
      "threads"_a = 0u,
      "progress"_a = py::none());
}

} // namespace pcl::acmap::python
