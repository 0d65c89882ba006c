#include "egomotion_options.h"

#include "egomotion_pictures.h"
#include "length_check.h"
#include "truth_comparison.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr double degrees = 180 / 3.14159265358979323846;

const char*
nameOf(EgomotionOutcome outcome)
{
  switch (outcome) {
  case EgomotionOutcome::Estimated:
    return "estimated";
  case EgomotionOutcome::BlankView:
    return "blank view";
  case EgomotionOutcome::FewFeatures:
    return "few features";
  case EgomotionOutcome::FewMatches:
    return "few matches";
  case EgomotionOutcome::Inconsistent:
    return "inconsistent";
  default:
    return "unobservable";
  }
}

/** Standard deviations of all degrees of freedom of the model, metres and radians. */
Json
deviationsOf(const EgomotionEstimate& estimate, bool is_rigid)
{
  const char* const names[] = {"x", "y", "z", "about_x", "about_y", "about_z"};
  Json deviations = Json::object();
  for (int i = 0; i < 6; ++i)
    if (is_rigid || i == 0 || i == 2 || i == 4)
      deviations[names[i]] = std::sqrt(estimate.covariance(i, i));
  return deviations;
}

Json
jsonOf(const EgomotionEstimate& estimate, bool is_rigid)
{
  Json json = {{"action",
                {{"dx", estimate.action.dx},
                 {"dz", estimate.action.dz},
                 {"dtheta", estimate.action.dtheta}}}};
  if (is_rigid) {
    const Eigen::Vector3d t = estimate.T_target_source.translation();
    const Eigen::Quaterniond q(estimate.T_target_source.linear());
    json["motion"] = {{"translation", {t.x(), t.y(), t.z()}},
                      {"quaternion", {q.x(), q.y(), q.z(), q.w()}}};
  }
  json["standard_deviations"] = deviationsOf(estimate, is_rigid);
  return json;
}

double
secondsOf(const EgomotionReport& report)
{
  double seconds = 0;
  for (const auto& step : report.seconds)
    seconds += step.second;
  return seconds;
}

Json
jsonOf(const OdometryPair& pair, const ObservationList& list, bool is_rigid)
{
  const EgomotionReport& report = pair.report;
  Json json = {{"observation", list.sequence.path(pair.now)},
               {"before", list.sequence.path(pair.before)},
               {"skipped", pair.skipped()},
               {"outcome", nameOf(report.outcome)}};
  if (pair.estimate)
    json.update(jsonOf(*pair.estimate, is_rigid));
  else
    json["reason"] = pair.reason(list.names);
  json.update({{"keypoints", report.source_keypoints},
               {"keypoints_before", report.target_keypoints},
               {"matches", report.matches},
               {"consistent", report.consistent},
               {"inliers", report.inliers},
               {"feature_residual", report.feature_residual},
               {"feature_chi", report.feature_chi},
               {"is_refined", report.is_refined},
               {"surface_pairs", report.surface_pairs},
               {"surface_before", report.surface_before},
               {"surface_after", report.surface_after},
               {"contradicted", report.contradicted},
               {"remarks", report.remarks},
               {"seconds", secondsOf(report)}});
  return json;
}

Json
jsonOf(const TruthComparison& comparison)
{
  const RelativePoseError& relative = comparison.relative;
  Json json = {{"pairs", relative.pairs},
               {"translation_rms", relative.translation_rms},
               {"translation_median", relative.translation_median},
               {"rotation_rms", relative.rotation_rms},
               {"rotation_median", relative.rotation_median},
               {"rotation_worst", relative.rotation_worst},
               {"trajectory_error", comparison.absolute.unaligned},
               {"trajectory_error_aligned", comparison.absolute.aligned}};
  if (comparison.is_way)
    json["translation_per_metre"] = relative.translation_per_metre;
  return json;
}

/** Length in metres, over the positions that are known. */
double
lengthOf(const Trajectory& trajectory)
{
  double length = 0;
  for (std::size_t i = 1; i < trajectory.poses.size(); ++i)
    length +=
        (trajectory.poses[i].translation() - trajectory.poses[i - 1].translation())
            .norm();
  return length;
}

/** Median of a function over all pairs with a motion. */
template <typename Function>
double
medianOf(const VisualOdometryResult& run, const Function& function)
{
  std::vector<double> values;
  for (const OdometryPair& pair : run.pairs)
    if (pair.estimate)
      values.push_back(static_cast<double>(function(pair)));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Medians of the estimated standard deviations of the motions, in the xz plane and
 * about y: metres, radians. */
Json
medianDeviations(const VisualOdometryResult& run)
{
  const auto deviation = [&](int i) {
    return medianOf(run, [i](const OdometryPair& pair) {
      return std::sqrt(pair.estimate->covariance(i, i));
    });
  };
  return {{"x", deviation(0)}, {"z", deviation(2)}, {"about_y", deviation(4)}};
}

constexpr std::size_t max_named = 20; ///< number of warnings of each kind on stderr

void
warnOfLost(Tool& tool, const ObservationList& list, const VisualOdometryResult& run)
{
  std::size_t lost = 0;
  for (std::size_t i = 0; i < list.sequence.size(); ++i)
    if (!run.poses[i] && ++lost <= max_named)
      tool.warn("lost: " + list.sequence.path(i) + ": " + run.reasonOf(i, list.names));
  if (lost > max_named)
    tool.warn(std::to_string(lost - max_named) +
              " further observations are lost, the report names them");
}

/** A single observation lost at the end is already reported in another line. */
void
warnOfEnd(Tool& tool, const ObservationList& list, const VisualOdometryResult& run)
{
  std::size_t end = list.sequence.size();
  while (end > 0 && !run.poses[end - 1])
    --end;
  if (list.sequence.size() - end > 1)
    tool.warn("nothing was joined from " + list.sequence.path(end) + " on: the last " +
              std::to_string(list.sequence.size() - end) + " observations are lost");
}

/** Views that are farther apart have less in common. */
void
warnOfSkips(Tool& tool, const ObservationList& list, const VisualOdometryResult& run)
{
  std::size_t skips = 0;
  for (const OdometryPair& pair : run.pairs)
    if (pair.estimate && pair.skipped() > 0 && ++skips <= max_named)
      tool.warn("skipped: " + list.sequence.path(pair.now) + ": was joined to " +
                list.names[pair.before] + ", past " + std::to_string(pair.skipped()) +
                " others, by " + std::to_string(pair.report.inliers) + " matches");
  if (skips > max_named)
    tool.warn(std::to_string(skips - max_named) +
              " further observations were joined past others, the report tells which");
}

Json
jsonOf(const FreeMotion& free)
{
  return {{"pairs", free.pairs},
          {"free", free.free},
          {"tilt", free.tilt},
          {"rise", free.rise}};
}

void
tellMotions(Tool& tool, const VisualOdometryResult& run)
{
  const auto deviation = [](int row) {
    return [row](const OdometryPair& pair) {
      return std::sqrt(pair.estimate->covariance.diagonal().segment<3>(row).sum());
    };
  };
  tool.tell(
      "matches",
      shortNumber(medianOf(run, [](auto& pair) { return pair.report.matches; })) +
          " a pair, of which " +
          shortNumber(medianOf(run, [](auto& pair) { return pair.report.inliers; })) +
          " agree (medians)");
  tool.tell("deviation",
            shortNumber(1000 * medianOf(run, deviation(0))) + " mm and " +
                shortNumber(degrees * medianOf(run, deviation(3))) +
                " degrees a pair (medians, as estimated)");
}

void
tellErrors(Tool& tool, const TruthComparison& comparison)
{
  const RelativePoseError& relative = comparison.relative;
  tool.tell("error",
            (comparison.is_way
                 ? shortNumber(100 * relative.translation_per_metre) + " % of the way, "
                 : std::string()) +
                shortNumber(degrees * relative.rotation_median) +
                " degrees a pair (median)");
  tool.tell("RPE",
            shortNumber(relative.translation_rms) + " m, " +
                shortNumber(degrees * relative.rotation_rms) + " degrees (rms)");
  tool.tell("ATE",
            shortNumber(comparison.absolute.aligned) + " m aligned, " +
                shortNumber(comparison.absolute.unaligned) + " m from the first on");
}

void
addDetails(Tool& tool,
           const EgomotionOptions& options,
           const ObservationList& list,
           const VisualOdometryResult& run,
           const std::optional<TruthComparison>& comparison)
{
  Json lost = Json::array(), pairs = Json::array(), posed_files = Json::array();
  for (std::size_t i = 0; i < list.sequence.size(); ++i)
    if (run.poses[i])
      posed_files.push_back(list.names[i]);
    else
      lost.push_back({{"observation", list.sequence.path(i)},
                      {"reason", run.reasonOf(i, list.names)}});
  for (const OdometryPair& pair : run.pairs)
    pairs.push_back(jsonOf(pair, list, options.is_rigid));
  tool.details() = {{"inputs", options.inputs},
                    {"output", options.output},
                    {"model", options.is_rigid ? "rigid" : "planar"},
                    {"max_translation", options.max_translation},
                    {"max_rotation", options.max_rotation / degrees},
                    {"keypoints", options.keypoints},
                    {"refinement", options.refines},
                    {"observations", list.sequence.size()},
                    {"posed", run.posed()},
                    {"length", lengthOf(run.trajectory(list.stamps))},
                    {"posed_files", posed_files},
                    {"lost", lost},
                    {"median_deviations", medianDeviations(run)},
                    {"free_motion", jsonOf(run.free)},
                    {"pairs", pairs}};
  if (comparison)
    tool.details()["truth"] = jsonOf(*comparison);
}

/** \brief Warns if the motion model was planar, but the camera left the floor. */
void
warnOfFreeMotion(Tool& tool, const VisualOdometryResult& run)
{
  const FreeMotion& free = run.free;
  if (2 * free.free <= free.pairs)
    return;
  tool.warn("the camera does not move level: from one observation to the next it tilts "
            "by " +
            shortNumber(degrees * free.tilt) + " degrees and rises or sinks by " +
            shortNumber(1000 * free.rise) + " mm (medians of " +
            std::to_string(free.pairs) + (free.pairs == 1 ? " pair" : " pairs") +
            "), which motions on a floor cannot follow: run again with --6dof");
}

/** \brief Reports the result for a sequence on stdout and in the report, and warns of
 * lost observations by name.
 * \param[in] comparison nothing if the truth is not known */
void
tellRun(Tool& tool,
        const EgomotionOptions& options,
        const ObservationList& list,
        const VisualOdometryResult& run,
        const std::optional<TruthComparison>& comparison)
{
  warnOfLost(tool, list, run);
  warnOfEnd(tool, list, run);
  warnOfSkips(tool, list, run);
  tool.tell("posed",
            std::to_string(run.posed()) + " of " +
                std::to_string(list.sequence.size()) + " observations, along " +
                shortNumber(lengthOf(run.trajectory(list.stamps))) + " m");
  tellMotions(tool, run);
  if (comparison)
    tellErrors(tool, *comparison);
  addDetails(tool, options, list, run, comparison);
}

/** Throws if there is no motion, and therefore no trajectory to write. */
void
requireMotion(const Tool& tool,
              const ObservationList& list,
              const VisualOdometryResult& run)
{
  const std::string& first = list.sequence.path(0);
  if (list.sequence.size() < 2)
    tool.failWithNothing(first +
                         ": is the only observation; two are needed for a motion");
  if (run.posed() == 0)
    tool.failWithNothing("no observation could be joined to another; " + first + " " +
                         run.reasonOf(0, list.names));
}

VisualOdometry::Egomotion
egomotionOf(const EgomotionOptions& options)
{
  constexpr double pi = 3.14159265358979323846;
  VisualOdometry::Egomotion egomotion;
  egomotion.setMotionModel(options.is_rigid ? MotionModel::Rigid : MotionModel::Planar);
  egomotion.setMaximumKeypoints(options.keypoints);
  egomotion.setRefinement(options.refines);
  egomotion.setMaximumTranslation(options.max_translation);
  egomotion.setMaximumRotation(options.max_rotation * pi / 180);
  return egomotion;
}

/** Draws the matches of each observation with the one that it was joined to; for a lost
 * one, those with the previous observation. */
VisualOdometry::PairCallback
matchDrawer(const OutputFolder& folder)
{
  return [&folder, drawn = std::optional<std::size_t>()](
             const OdometryPair& pair,
             const VisualOdometry::Egomotion& egomotion) mutable {
    if (pair.estimate || drawn != pair.now)
      savePng(folder.path(numberedName("matches", pair.now, ".png")),
              matchPicture(*egomotion.getInputSource(),
                           *egomotion.getInputTarget(),
                           egomotion.getMatches(),
                           egomotion.getInliers()));
    drawn = pair.now;
  };
}

VisualOdometryResult
run(Tool& tool,
    const EgomotionOptions& options,
    const ObservationList& list,
    const OutputFolder& folder)
{
  VisualOdometry odometry;
  odometry.setEgomotion(egomotionOf(options));
  odometry.setNumberOfThreads(tool.threads());
  if (options.pictures)
    odometry.setPairCallback(matchDrawer(folder));
  if (options.writes_observations)
    odometry.setPoseCallback([&](std::size_t index,
                                 const PointCloudFile& observation,
                                 const Eigen::Isometry3d& T_map_camera) {
      PCLPointCloud2 cloud = observation.cloud;
      dropUnwritableFields(cloud);
      saveObservation(folder.path(list.outputs[index]), cloud, T_map_camera);
    });
  warnOfLengths(*list.sequence.load(0).file, tool.controls(), tool.log());
  VisualOdometryResult found;
  tool.withProgress([&](const ProgressCallback& progress) {
    odometry.setProgressCallback(progress);
    found = odometry.compute(list.sequence);
  });
  return found;
}

} // namespace

void
estimatePoses(Tool& tool,
              const EgomotionOptions& options,
              const std::optional<ObservationSequence>& opened)
{
  StepTimer timer(tool.report());
  const ObservationList list = listObservations(tool, options.inputs, opened);
  const std::vector<Eigen::Isometry3d> truth = loadTruth(tool, options.truth, list);
  OutputFolder folder(options.output);
  requireFit(folder, list.sequence);
  tool.requireReportWritable(list.sequence.paths());
  timer.finish("list");

  const VisualOdometryResult found = run(tool, options, list, folder);
  warnOfFreeMotion(tool, found);
  requireMotion(tool, list, found);
  timer.finish("estimate");

  std::optional<TruthComparison> comparison;
  if (!truth.empty())
    comparison = compare(truth, found, options.is_rigid);
  pcl::saveTrajectory(folder.path(trajectory_name), found.trajectory(list.stamps));
  savePng(
      folder.path("plan.png"),
      wayPicture(found.poses,
                 comparison ? comparison->truth : std::vector<Eigen::Isometry3d>()));
  tool.stopIfInterrupted();
  // another run may have written into the folder meanwhile
  requireFit(folder, list.sequence);
  folder.commit();
  timer.finish("write");
  tellRun(tool, options, list, found, comparison);
  tool.tellSeconds();
  tool.tell("folder", options.output);
}

} // namespace pcl::acmap
