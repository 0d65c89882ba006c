#include "bindings.h"
#include "kernel_call.h"
#include "named_choice.h"
#include "poses.h"
#include "reports.h"
#include "results.h"
#include "setter_keyword.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/impl/levelling_kernel.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/point_types.h>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

constexpr NamedChoices<RectificationMode, 2> modes = {
    {{"guarded", RectificationMode::Guarded}, {"paper", RectificationMode::Paper}}};

/** Result of rectify. */
struct Rectified {
  py::array_t<double> poses;
  ReportObject report;
};

/** An observation before its points are copied. */
struct Observation {
  PointView points;
  PointView normals;
  std::vector<float> weights;
};

std::vector<float>
weightsOf(const std::string& name, const py::handle& argument, std::size_t points)
{
  const Column column = columnOf(name, argument, py::dtype::of<float>(), points);
  std::vector<float> weights(column.size);
  for (std::size_t i = 0; i < weights.size(); ++i)
    std::memcpy(&weights[i],
                static_cast<const char*>(column.first) + column.stride * i,
                sizeof(float));
  requirePointWeights(weights, points);
  return weights;
}

/** The lists that rectify accepts, with one entry per observation. */
struct ObservationArguments {
  std::vector<PointArgument> clouds;
  std::optional<std::vector<PointArgument>> normals;
  std::optional<std::vector<WeightArgument>> weights;
};

void
requireOneEach(const std::string& name, std::size_t number, std::size_t clouds)
{
  if (number != clouds)
    throw py::value_error(name + ": there are " + std::to_string(number) + " for " +
                          std::to_string(clouds) + " clouds");
}

std::vector<Observation>
observationsOf(const ObservationArguments& arguments)
{
  const std::size_t size = arguments.clouds.size();
  if (arguments.normals)
    requireOneEach("normals", arguments.normals->size(), size);
  if (arguments.weights)
    requireOneEach("weights", arguments.weights->size(), size);
  std::vector<Observation> observations(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    Observation& seen = observations[i];
    seen.points = pointRowsOf("clouds" + place, arguments.clouds[i]).view;
    if (arguments.normals) {
      seen.normals = pointRowsOf("normals" + place, (*arguments.normals)[i]).view;
      requireAsMany("normals" + place, seen.normals.size(), seen.points.size());
    }
    if (arguments.weights)
      seen.weights =
          weightsOf("weights" + place, (*arguments.weights)[i], seen.points.size());
  }
  return observations;
}

/** The rectified poses of the sensors, or the given ones unless it succeeded. */
Poses
search(const std::vector<Observation>& observations,
       const Poses& given,
       const std::optional<Eigen::Vector3d>& up,
       const RectificationSettings& settings,
       unsigned threads,
       const Progress& progress,
       EntropyRectificationReport& report)
{
  StepTimer timer(report);
  std::vector<ObservedSurface> surfaces(up ? 0 : observations.size());
  std::vector<LevelledPoints> levelled(observations.size());
  std::vector<PlanarPose> planar;
  Poses upright_poses;
  Eigen::Quaterniond upright;
  withThreads(threads, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, surfaces.size(), [&](std::size_t i) {
      const Observation& seen = observations[i];
      surfaces[i] = observedSurface(seen.points, seen.normals, seen.weights);
    });
    upright = uprightRotation(verticalOf(surfaces, given, up, report));
    for (const Eigen::Isometry3d& pose : given) {
      upright_poses.push_back(upright * pose);
      planar.push_back(planarPartOf(upright_poses.back()));
    }
    oneapi::tbb::parallel_for(std::size_t{0}, given.size(), [&](std::size_t i) {
      const Observation& seen = observations[i];
      levelled[i] =
          levelledPoints(seen.points, seen.normals, upright_poses[i], seen.weights);
    });
    timer.finish("level");
    planar = rectify(levelled, planar, settings, progress, report);
  });
  timer.finish("search");
  if (report.outcome != RectificationOutcome::Rectified)
    return given;
  Poses poses;
  for (std::size_t i = 0; i < given.size(); ++i)
    poses.push_back(upright.inverse() * isometryOf(planar[i]) *
                    levelOf(upright_poses[i]));
  return poses;
}

Rectified
rectifyClouds(const ObservationArguments& arguments,
              const PoseArgument& poses,
              const std::optional<Eigen::Vector3d>& up,
              const RectificationSettings& settings,
              unsigned threads,
              const Listener& listener)
{
  const std::vector<Observation> observations = observationsOf(arguments);
  const Poses given = posesOf("poses", poses);
  requireOneEach("poses", given.size(), observations.size());
  if (given.empty())
    throw py::value_error("clouds: there is none");
  EntropyRectificationReport report;
  const auto [found, owner] = owned(callKernel(listener, [&](const Progress& progress) {
    return search(observations, given, up, settings, threads, progress, report);
  }));
  return {arrayOfPoses(found, owner), reportOf(report)};
}

constexpr const char* about_rectification =
    R"(Straightens a map: finds the poses of observations under which their points fit
together best, without matching any of them (pcl::EntropyRectification, II-B.2 of the
paper). Returns a Rectified.

clouds            a list of (n, 3) or (h, w, 3) float32, metres, each in its sensor's frame,
                  in the order in which they were made
poses             (k, 4, 4) float64: T_map_camera of each; poses move perpendicularly to
                  the vertical and turn about it, heights and tilts stay
normals           a list as clouds, unit; should be given (consolidate makes them)
weights           a list of (n,) float32: how much each point counts; None: 1
mode              'guarded': entropy with an odometry prior, judged by rays; 'paper': Eq. 3
                  alone, by voting, without a guard
bin_size          metres, edge of the finest bins
entropy_weight    how much a bit of entropy counts against the odometry, times the default
smoothing         metres, sigma_XZ of 'paper'; None: one bin. 'guarded' refuses it
projection_weight mu, of the entropies along the building's main directions; None: 0 if
                  guarded, 0.1 as the paper
up                three numbers, the up direction of the map; None: found by floors and
                  walls, see report.up_reason
odometry_length, odometry_length_per_metre, odometry_turn, odometry_turn_per_radian
                  what the odometry is expected to err by, one standard deviation: metres,
                  m/m, radians, rad/rad; left as they are, planar scans may tell others
seed              of the voting
threads           0: all; the result is the same bytes for every number
progress          called with (fraction, step); stops the run when it returns False)";

} // namespace

void
bindRectification(py::module_& module)
{
  bindResult<Rectified>(
      module,
      "Rectified",
      "What rectify found.",
      "poses report",
      field("poses",
            &Rectified::poses,
            "(k, 4, 4) float64, T_map_camera; as they came unless "
            "report.outcome is 'rectified'"),
      field("report",
            &Rectified::report,
            "outcome, its reason, evidence, seconds and remarks, named as in "
            "pcl::EntropyRectificationReport"));
  const RectificationSettings defaults;
  module.def(
      "rectify",
      [](std::vector<PointArgument> clouds,
         const PoseArgument& poses,
         std::optional<std::vector<PointArgument>> normals,
         std::optional<std::vector<WeightArgument>> weights,
         const std::string& mode,
         double bin_size,
         double entropy_weight,
         std::optional<double> projection_weight,
         std::optional<double> smoothing,
         const std::optional<std::array<double, 3>>& up,
         double odometry_length,
         double odometry_length_per_metre,
         double odometry_turn,
         double odometry_turn_per_radian,
         std::uint64_t seed,
         unsigned threads,
         const Listener& progress) {
        using Rectification = EntropyRectification<pcl::PointNormal>;
        Rectification rectification;
        rectification.setMode(chosen("mode", mode, modes));
        setKeyword("bin_size", rectification, &Rectification::setBinSize, bin_size);
        setKeyword("entropy_weight",
                   rectification,
                   &Rectification::setEntropyWeight,
                   entropy_weight);
        setKeyword("projection_weight",
                   rectification,
                   &Rectification::setProjectionWeight,
                   projection_weight);
        setKeyword("smoothing", rectification, &Rectification::setSmoothing, smoothing);
        if (smoothing && rectification.getMode() != RectificationMode::Paper)
          throw py::value_error("smoothing: is for mode 'paper'");
        const OdometryNoise usual;
        if (odometry_length != usual.length ||
            odometry_length_per_metre != usual.length_per_metre ||
            odometry_turn != usual.turn ||
            odometry_turn_per_radian != usual.turn_per_radian)
          rectification.setOdometryNoise({odometry_length,
                                          odometry_length_per_metre,
                                          odometry_turn,
                                          odometry_turn_per_radian});
        rectification.setSeed(seed);
        if (up)
          setKeyword("up",
                     rectification,
                     &Rectification::setUpDirection,
                     Eigen::Vector3d((*up)[0], (*up)[1], (*up)[2]));
        return rectifyClouds(
            {std::move(clouds), std::move(normals), std::move(weights)},
            poses,
            rectification.getUpDirection(),
            rectification.settings(),
            threads,
            progress);
      },
      about_rectification,
      "clouds"_a,
      "poses"_a,
      py::kw_only(),
      "normals"_a = py::none(),
      "weights"_a = py::none(),
      "mode"_a = nameOf(defaults.mode, modes),
      "bin_size"_a = defaults.bin_size,
      "entropy_weight"_a = defaults.entropy_weight,
      "projection_weight"_a = py::none(),
      "smoothing"_a = py::none(),
      "up"_a = py::none(),
      "odometry_length"_a = defaults.odometry.length,
      "odometry_length_per_metre"_a = defaults.odometry.length_per_metre,
      "odometry_turn"_a = defaults.odometry.turn,
      "odometry_turn_per_radian"_a = defaults.odometry.turn_per_radian,
      "seed"_a = defaults.seed,
      "threads"_a = 0u,
      "progress"_a = py::none());
}

} // namespace pcl::acmap::python
