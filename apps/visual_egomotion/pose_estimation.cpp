#include "egomotion_options.h"

#include "output_target.h"
#include "pose_options.h"

#include <pcl/core/fields_json.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/output_folder.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/odometry_comparison.h>
#include <pcl/pipeline/odometry_pictures.h>
#include <pcl/pipeline/visual_odometry.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;
using Poses = std::vector<Eigen::Isometry3d>;

constexpr double degrees = 180 / 3.14159265358979323846;

/** The observations whose poses are to be estimated, in their order. */
struct ObservationList {
  const ObservationSequence& sequence;
  std::vector<std::string> names;   ///< without their folders
  std::vector<std::string> outputs; ///< output names of observations with a pose
  std::vector<double> stamps;       ///< seconds, or indices in the sequence
};

/** Takes the stamps of the folder's trajectory, if it has a row for each file. Poses of
 * the input are not used, so that invalid ones are no error. */
void
takeStamps(const std::string& folder, ObservationList& list, StageLog& log)
{
  try {
    const ObservationSequence posed(folder);
    for (std::size_t i = 0; i < list.stamps.size(); ++i)
      list.stamps[i] = posed.stamp(i);
  }
  catch (const InputFileException&) {
    log.warn("stamps are numbers, as those of the input cannot be used: " +
             failureOf(std::current_exception()).line);
  }
}

bool
comeBackInOrder(const std::vector<std::string>& names)
{
  return inSequence(names) == names &&
         std::adjacent_find(names.begin(), names.end()) == names.end() &&
         std::all_of(names.begin(), names.end(), [](const std::string& name) {
           return endingOf(name) == ".pcd";
         });
}

/** Posed files keep their names; if names would be read back in another order, or are
 * given twice, they become observation_0000.pcd and so on, with a warning. */
ObservationList
listObservations(const EgomotionOptions& options,
                 const ObservationSequence& sequence,
                 StageLog& log)
{
  ObservationList list{sequence, sequence.names(), sequence.names(), {}};
  list.stamps.resize(list.names.size());
  std::iota(list.stamps.begin(), list.stamps.end(), 0.0);
  if (options.hasFolder())
    takeStamps(options.inputs.front(), list, log);
  if (!comeBackInOrder(list.names)) {
    for (std::size_t i = 0; i < list.outputs.size(); ++i)
      list.outputs[i] = observationName(i);
    log.warn("the observations are named anew, since a folder would have them in "
             "another order than the one given");
  }
  return list;
}

/** Checks that the results would neither replace nor mix with other files. */
void
requireFit(const OutputFolder& folder, const ObservationSequence& sequence)
{
  for (const std::string& path : sequence.paths())
    if (folder.holds(path))
      throw UsageError(folder.name() + ": holds the input; name another folder");
  requireNoneIn(folder, [](const std::string& name) {
    // replacing a report would leave the map without its own
    return isSequenceName(name) || endingOf(name) == ".pcd" || name == "plan.png" ||
           name == "report.json" || name.rfind("map.", 0) == 0 ||
           name.rfind("matches_", 0) == 0;
  });
}

/** Standard deviations of all degrees of freedom of the model, metres and radians. */
Json
deviationsOf(const EgomotionEstimate& estimate, bool is_rigid)
{
  const char* const names[] = {"x", "y", "z", "about_x", "about_y", "about_z"};
  Json deviations = Json::object();
  for (int i = 0; i < 6; ++i)
    if (is_rigid || i % 2 == 0)
      deviations[names[i]] = std::sqrt(estimate.covariance(i, i));
  return deviations;
}

Json
jsonOf(const EgomotionEstimate& estimate, bool is_rigid)
{
  Json json = {{"action", fieldsOf(estimate.action)}};
  if (is_rigid) {
    const Eigen::Vector3d t = estimate.T_target_source.translation();
    const Eigen::Quaterniond q(estimate.T_target_source.linear());
    json["motion"] = {{"translation", {t.x(), t.y(), t.z()}},
                      {"quaternion", {q.x(), q.y(), q.z(), q.w()}}};
  }
  json["standard_deviations"] = deviationsOf(estimate, is_rigid);
  return json;
}

Json
jsonOf(const OdometryPair& pair, const ObservationList& list, bool is_rigid)
{
  const EgomotionReport& report = pair.report;
  Json json = {{"observation", list.sequence.path(pair.now)},
               {"before", list.sequence.path(pair.before)},
               {"skipped", pair.skipped()},
               {"outcome", nameIn(egomotion_outcome_names, report.outcome)}};
  if (pair.estimate)
    json.update(jsonOf(*pair.estimate, is_rigid));
  else
    json["reason"] = pair.reason(list.names);
  double seconds = 0;
  for (const auto& step : report.seconds)
    seconds += step.second;
  json.update(
      fieldsOf(report, {{"reason"}, {"points"}, {"points_before"}, {"is_paper"}}));
  json["remarks"] = report.remarks;
  json["seconds"] = seconds;
  return json;
}

Json
jsonOf(const OdometryComparison& comparison)
{
  const RelativePoseError& relative = comparison.relative;
  Json json =
      fieldsOf(relative, {{"translation_per_metre"}, {"translation_per_metre_median"}});
  json.update(fieldsOf(comparison.absolute));
  if (comparison.is_moving)
    json["translation_per_metre"] = relative.translation_per_metre;
  return json;
}

/** Warns of lost observations, and of those that were joined past others: views that
 * are farther apart have less in common. */
void
warnOfGaps(const ObservationList& list, const VisualOdometryResult& run, StageLog& log)
{
  const std::size_t size = list.names.size();
  std::vector<std::string> lost, skips;
  std::size_t end = 0; // of the posed observations
  for (std::size_t i = 0; i < size; ++i)
    if (run.poses[i])
      end = i + 1;
    else
      lost.push_back("lost: " + list.sequence.path(i) + ": " +
                     run.reasonOf(i, list.names));
  constexpr std::size_t max_named = 20;
  log.warnOfFirst(
      max_named, lost, "further observations are lost, the report names them");
  // a single observation lost at the end is already reported in another line
  if (size - end > 1)
    log.warn("nothing was joined from " + list.sequence.path(end) + " on: the last " +
             std::to_string(size - end) + " observations are lost");
  for (const OdometryPair& pair : run.pairs)
    if (pair.estimate && pair.skipped() > 0)
      skips.push_back("skipped: " + list.sequence.path(pair.now) + ": was joined to " +
                      list.names[pair.before] + ", past " +
                      std::to_string(pair.skipped()) + " others, by " +
                      std::to_string(pair.report.inliers) + " matches");
  log.warnOfFirst(
      max_named,
      skips,
      "further observations were joined past others, the report tells which");
}

/** Adds the lines of the summary. */
void
tellRun(const VisualOdometryResult& run,
        const OdometryFigures& figures,
        const std::optional<OdometryComparison>& comparison,
        StageLog& log)
{
  log.tell("posed",
           std::to_string(run.posed()) + " of " + std::to_string(run.poses.size()) +
               " observations, along " + shortNumber(figures.length) + " m");
  log.tell("matches",
           shortNumber(figures.matches) + " a pair, of which " +
               shortNumber(figures.inliers) + " agree (medians)");
  log.tell("deviation",
           shortNumber(1000 * figures.translation) + " mm and " +
               shortNumber(degrees * figures.rotation) +
               " degrees a pair (medians, as estimated)");
  if (!comparison)
    return;
  const RelativePoseError& relative = comparison->relative;
  log.tell("error",
           (comparison->is_moving
                ? shortNumber(100 * relative.translation_per_metre) + " % of the way, "
                : std::string()) +
               shortNumber(degrees * relative.rotation_median) +
               " degrees a pair (median)");
  log.tell("RPE",
           shortNumber(relative.translation_rms) + " m, " +
               shortNumber(degrees * relative.rotation_rms) + " degrees (rms)");
  log.tell("ATE",
           shortNumber(comparison->absolute.aligned) + " m aligned, " +
               shortNumber(comparison->absolute.unaligned) + " m from the first on");
}

Json
detailsOf(const EgomotionOptions& options,
          const ObservationList& list,
          const VisualOdometryResult& run,
          const OdometryFigures& figures,
          const std::optional<OdometryComparison>& comparison)
{
  Json lost = Json::array(), pairs = Json::array(), posed_files = Json::array();
  for (std::size_t i = 0; i < list.names.size(); ++i)
    if (run.poses[i])
      posed_files.push_back(list.names[i]);
    else
      lost.push_back({{"observation", list.sequence.path(i)},
                      {"reason", run.reasonOf(i, list.names)}});
  const bool is_rigid = run.model == MotionModel::Rigid;
  for (const OdometryPair& pair : run.pairs)
    pairs.push_back(jsonOf(pair, list, is_rigid));
  const VisualOdometry::Egomotion& stage = options.stage;
  Json details = {{"inputs", options.inputs},
                  {"output", options.output},
                  {"mode", stage.getPaperMode() ? "paper" : "accurate"},
                  {"fits", figures.fits},
                  {"model", nameIn(motion_model_names, run.model)},
                  {"max_translation", stage.getMaximumTranslation()},
                  {"max_rotation", stage.getMaximumRotation()},
                  {"keypoints", stage.getMaximumKeypoints()},
                  {"refinement", stage.getRefinement() && !stage.getPaperMode()},
                  {"observations", list.names.size()},
                  {"posed", run.posed()},
                  {"length", figures.length},
                  {"posed_files", posed_files},
                  {"lost", lost},
                  {"median_deviations",
                   {{"x", figures.x}, {"z", figures.z}, {"about_y", figures.about_y}}},
                  {"free_motion", fieldsOf(run.free)},
                  {"pairs", pairs}};
  if (comparison)
    details["truth"] = jsonOf(*comparison);
  return details;
}

/** Throws if there is no motion, and therefore no trajectory to write. */
void
requireMotion(const ObservationList& list,
              const VisualOdometryResult& run,
              const StageLog& log)
{
  const std::string& first = list.sequence.path(0);
  if (list.names.size() < 2)
    log.failWithNothing(first +
                        ": is the only observation; two are needed for a motion");
  if (run.posed() == 0)
    log.failWithNothing("no observation could be joined to another; " + first + " " +
                        run.reasonOf(0, list.names));
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
run(const EgomotionOptions& options,
    const ObservationList& list,
    const OutputFolder& folder,
    const RunControls& controls,
    StageLog& log)
{
  VisualOdometry odometry;
  odometry.setEgomotion(options.stage);
  odometry.setMeasureMotion(options.measures_path);
  odometry.setNumberOfThreads(controls.threads);
  odometry.setProgressCallback(controls.progress);
  if (options.pictures)
    odometry.setPairCallback(matchDrawer(folder));
  odometry.setPoseCallback([&](std::size_t index,
                               const PointCloudFile& observation,
                               const Eigen::Isometry3d& T_map_camera) {
    PCLPointCloud2 cloud = observation.cloud;
    dropUnwritableFields(cloud);
    saveObservation(folder.path(list.outputs[index]), cloud, T_map_camera);
  });
  VisualOdometryResult found = odometry.compute(list.sequence);
  log.warn(odometry.getReport().remarks);
  return found;
}

void
tellAll(const EgomotionOptions& options,
        const ObservationList& list,
        const VisualOdometryResult& found,
        const std::optional<OdometryComparison>& comparison,
        StageLog& log)
{
  const OdometryFigures figures = figuresOf(found);
  warnOfGaps(list, found, log);
  if (options.measures_path && !options.stage.getPaperMode())
    tellPath(found.path(), log);
  tellRun(found, figures, comparison, log);
  log.details.update(detailsOf(options, list, found, figures, comparison));
}

} // namespace

void
tellOdometry(const EgomotionOptions& options,
             const ObservationSequence& sequence,
             const VisualOdometryResult& found,
             const std::string& plan,
             StageLog& log)
{
  savePng(plan, trajectoryPicture(found.poses, {}));
  const ObservationList list{sequence, sequence.names(), {}, {}};
  tellAll(options, list, found, std::nullopt, log);
}

void
estimatePoses(const EgomotionOptions& options,
              const ObservationSequence& sequence,
              const RunControls& controls,
              StageLog& log)
{
  StepTimer timer(log.report);
  const ObservationList list = listObservations(options, sequence, log);
  Poses truth;
  if (!options.truth.empty())
    truth = loadTruePoses(
        options.truth, list.names, controls.reader.getScale(), log.report.remarks);
  OutputFolder folder(options.output);
  requireFit(folder, sequence);
  timer.finish("list");

  const VisualOdometryResult found = run(options, list, folder, controls, log);
  requireMotion(list, found, log);
  timer.finish("estimate");

  std::optional<OdometryComparison> comparison;
  if (!truth.empty())
    comparison = compareWithTruth(found, truth);
  const Trajectory trajectory = found.estimated(list.stamps).trajectory;
  saveTrajectory(folder.path(trajectory_name), trajectory);
  savePng(folder.path("plan.png"),
          trajectoryPicture(found.poses, comparison ? comparison->truth : Poses()));
  stopIfInterrupted();
  // another run may have written into the folder meanwhile
  requireFit(folder, sequence);
  folder.commit();
  timer.finish("write");
  tellAll(options, list, found, comparison, log);
  log.tellSeconds();
  log.tell("folder", options.output);
}

} // namespace pcl::acmap
