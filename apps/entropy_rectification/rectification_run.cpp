#include "rectification_options.h"

#include "log_observations.h"
#include "memory.h"
#include "output_target.h"
#include "pose_adjustment.h"
#include "pose_options.h"
#include "stage_reports.h"

#include <pcl/core/fields_json.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/pipeline/chain.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;
using Poses = std::vector<Eigen::Isometry3d>;
using Clouds = std::vector<PointCloud<PointNormal>::Ptr>;
using Rectification = EntropyRectification<PointNormal>;

constexpr double degrees = 180 / 3.14159265358979323846;
constexpr double rectified =
    0.9; ///< fraction of the progress, before files are written

const char*
outcomeName(RectificationOutcome outcome)
{
  return nameIn(rectification_outcome_names, outcome);
}

Json
detailsOf(const RectificationOptions& options, const EntropyRectificationReport& report)
{
  Json details = {{"input", options.input()},
                  {"output", options.output},
                  {"mode", nameIn(rectification_mode_names, options.stage.getMode())},
                  {"bin_size", options.stage.getBinSize()},
                  {"seed", options.stage.getSeed()}};
  details.update(fieldsOf(report,
                          {{"reason", outcomeName(report.outcome)},
                           {"up"}, // told of the levelling
                           {"is_up_found"},
                           {"up_reason"},
                           {"votes"},
                           {"accepted_moves"},
                           {"refused_poses"}, // as many as there are observations
                           {"steps"}}));
  details["steps"] = columnsOf(report.steps);
  details["rectification_seconds"] = secondsOf(report);
  return details;
}

double
largestOf(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void
tellEvidence(const EntropyRectificationReport& report, StageLog& log)
{
  const bool is_new = report.outcome == RectificationOutcome::Rectified;
  // fraction of rays before and after
  const auto change = [&](const auto& fraction) {
    return shortNumber(100 * fraction(report.before)) +
           (is_new ? " % before, " : " % (best candidate ") +
           shortNumber(100 * fraction(report.after)) + (is_new ? " % after" : " %)");
  };
  using Evidence = const MapEvidence&;
  log.tell("contradicted",
           "of the rays that near observations tell about " + change([](Evidence rays) {
             return rays.near_contradictions;
           }) + "; of those that far ones do " +
               change([](Evidence rays) { return rays.far_contradictions; }));
  log.tell("confirmed",
           "of all rays by near observations " + change([](Evidence rays) {
             return rays.near_rays * (1 - rays.near_contradictions);
           }) + "; by far ones " +
               change([](Evidence rays) {
                 return rays.far_rays * (1 - rays.far_contradictions);
               }));
}

/** What an estimate of its own says of the poses: first of all if it keeps the given ones. */
void
tellVerdict(const EntropyRectificationReport& report, StageLog& log)
{
  const MapVerdictReport& verdict = *report.verdict;
  std::string reasons;
  for (const std::string& reason : verdict.reasons)
    reasons += (reasons.empty() ? "" : "; ") + reason;
  log.tell("verdict",
           std::string(nameIn(verdict_outcome_names, verdict.outcome)) + ": " +
               reasons);
  const std::string option = "; --odometry-noise states what the odometry errs by";
  if (report.outcome == RectificationOutcome::Undetermined &&
      !report.refused_poses.empty())
    log.lines.insert(log.lines.begin(),
                     {"undetermined", "the given poses are kept: " + reasons + option});
  if (verdict.outcome == VerdictOutcome::Contradicted &&
      verdict.given == VerdictOutcome::Contradicted)
    log.contradiction = "the poses are contradicted: " + report.reason +
                        (report.refused_poses.empty() ? "; " + reasons : "") + option;
}

void
tellOutcome(const EntropyRectificationReport& report, StageLog& log)
{
  log.tell(outcomeName(report.outcome), report.reason);
  if (report.verdict)
    tellVerdict(report, log);
  if (report.before.rays > 0)
    tellEvidence(report, log);
  log.tell("moved",
           "at most " + shortNumber(largestOf(report.moved)) + " m and " +
               shortNumber(degrees * largestOf(report.turned)) + " degrees");
  const bool is_told =
      report.verdict && report.verdict->outcome == VerdictOutcome::Consistent;
  if (report.expected_error && !is_told)
    log.tell("error left",
             "at most " + shortNumber(*report.expected_error) +
                 " m (95 %), as neighbouring walls and the odometry tell");
}

std::string
nameOfAxis(const Eigen::Vector3d& axis)
{
  int number = 0;
  axis.cwiseAbs().maxCoeff(&number);
  return std::string(axis[number] < 0 ? "-" : "") + "xyz"[number];
}

void
tellLevel(const MapLevellingReport& report, StageLog& log)
{
  const double tilt = degrees * report.tilt;
  log.tell("up",
           nameOfAxis(report.axis) + ", " + report.reason +
               (tilt > 0
                    ? "; the map was turned level by " + shortNumber(tilt) + " degrees"
                    : ""));
  Json& details = log.details["level"];
  details = fieldsOf(report,
                     {{"observations"},
                      {"points"},
                      {"invalid_points"},
                      {"tilt", "tilt_deg"},
                      {"uncertainty"},
                      {"reason"}});
  details["tilt_deg"] = tilt;
}

/** Writes the map and the observations, if they are wanted.
 * \param[in] posed the observations at their new poses */
void
writeObservations(const RectificationOptions& options,
                  const ObservationSequence& posed,
                  const SequenceConsolidationReport& consolidated,
                  const OutputFolder& folder,
                  const RunControls& controls)
{
  if (!options.write_map && !options.write_observations)
    return;
  MapRows map(
      options.write_map ? consolidated.points : 0, consolidated.colored, memoryCheck());
  const Progress progress(partOf(controls.progress, rectified, 1));
  for (std::size_t i = 0; i < posed.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(posed.size()),
                  "writing");
    const PosedObservation seen = posed.load(i);
    if (options.write_map)
      map.append(*seen.file, seen.T_map_camera, static_cast<std::int32_t>(i));
    if (options.write_observations) {
      PCLPointCloud2 cloud = seen.file->cloud;
      dropUnwritableFields(cloud);
      saveObservation(folder.path(observationName(i)), cloud, seen.T_map_camera);
    }
  }
  if (options.write_map)
    savePointCloud(folder.path("map.pcd"), map.finish());
}

void
writePoses(const Trajectory& before, const Poses& after, const OutputFolder& folder)
{
  saveTrajectory(folder.path(trajectory_name), {before.stamps, after});
  saveTrajectory(folder.path("trajectory_before.txt"), before);
}

void
requirePlace(const RectificationOptions& options, const OutputFolder& folder)
{
  if (folder.holds(options.input()) || folder.holds(options.input() + "/any"))
    throw UsageError(options.output + ": holds the input; name another folder");
  requireNoSequence(folder);
}

/** The given vertical; that of a log is y. */
MapLevelling<PointNormal>
levellingOf(const RectificationOptions& options)
{
  MapLevelling<PointNormal> levelling;
  if (options.up)
    levelling.setUpDirection(*options.up);
  else if (!options.log.empty())
    levelling.setUpDirection(-Eigen::Vector3d::UnitY());
  return levelling;
}

void
tellFiles(const RectificationOptions& options,
          const std::vector<std::string>& files,
          StageLog& log)
{
  log.details["posed_files"] = files;
  log.tellSeconds();
  log.tell("folder", options.output);
}

} // namespace

void
tellRectification(const RectificationOptions& options,
                  const MapLevellingReport& levelling,
                  const EntropyRectificationReport& report,
                  StageLog& log)
{
  tellLevel(levelling, log);
  tellOutcome(report, log);
  log.details.update(detailsOf(options, report));
  if (options.stage.getMode() == RectificationMode::Paper)
    log.details.update(
        Json{{"smoothing",
              options.stage.getSmoothing().value_or(options.stage.getBinSize())},
             {"votes", report.votes},
             {"accepted_moves", report.accepted_moves}});
}

void
tellConsolidated(const SequenceConsolidationReport& report,
                 std::size_t observations,
                 bool is_raw,
                 StageLog& log)
{
  log.tell("read",
           std::to_string(observations) + " observations, " +
               std::to_string(report.points) + " points");
  log.tell("consolidated",
           is_raw ? "no, the paper takes raw points"
                  : "to " + std::to_string(report.representatives) + ", voxels of " +
                        shortNumber(report.min_voxel_size) + " to " +
                        shortNumber(report.max_voxel_size) + " m");
  log.details["consolidated_points"] = report.representatives;
  log.details["consolidation"] = fieldsOf(report, {{"points"}, {"colored"}});
}

void
savePictures(const RectificationPictures& pictures,
             const std::function<std::string(const char*)>& place)
{
  savePng(place("plan_before.png"), pictures.plan_before);
  savePng(place("plan_after.png"), pictures.plan_after);
  savePng(place("plan.png"), pictures.plan);
  savePng(place("energy.png"), pictures.energy);
}

void
rectifyPoses(const RectificationOptions& options,
             const ObservationSequence& posed,
             const RunControls& controls,
             StageLog& log)
{
  StepTimer timer(log.report);
  OutputFolder folder(options.output);
  requirePlace(options, folder);
  ChainSettings settings;
  settings.poses = options.poses;
  settings.levelling = levellingOf(options);
  settings.rectification = options.stage;
  settings.rectifies_one = true;
  settings.adjust = options.six_degrees;
  settings.measure_path =
      options.measures_path && options.stage.getMode() != RectificationMode::Paper;
  settings.skip_broken = options.skip_broken;
  Chain chain(std::move(settings));
  chain.setInput(posed, true);
  chain.setNumberOfThreads(controls.threads);
  chain.setProgressCallback(partOf(controls.progress, 0, rectified));
  const ChainState& state = chain.run("adjustment");
  const CompactMappingReport& report = state.report;
  timer.finish("rectify");
  const ObservationSequence& mapped = *state.observations;
  const Poses& poses = state.estimated.trajectory.poses;
  writeObservations(options, mapped, *report.consolidation, folder, controls);
  writePoses(state.before, poses, folder);
  savePictures(drawRectification(state.rectified.clouds,
                                 state.before.poses,
                                 poses,
                                 report.levelling->axis,
                                 report.rectification->steps),
               [&](const char* name) { return folder.path(name); });
  stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  log.warn(report.remarks);
  const bool is_raw = options.stage.getMode() == RectificationMode::Paper;
  tellPoseReading(options.poses, report.pose_convention, log);
  if (report.path)
    tellPath(*report.path, log);
  tellConsolidated(*report.consolidation, mapped.size(), is_raw, log);
  tellRectification(options, *report.levelling, *report.rectification, log);
  if (report.adjustment)
    tellAdjustment(*report.adjustment, report.revisits, log);
  tellFiles(options, mapped.names(), log);
}

void
rectifyScans(const RectificationOptions& options,
             const RunControls& controls,
             StageLog& log)
{
  StepTimer timer(log.report);
  OutputFolder folder(options.output);
  requirePlace(options, folder);
  LaserObservations scans = readScans(options, log);
  if (scans.points == 0)
    throw NothingFound(options.input() + ": has no point");
  timer.finish("read");
  const MapLevellingReport levelled =
      levelObservations(levellingOf(options), scans, controls.threads);
  Rectification rectification = options.stage;
  rectification.setUpDirection(levelled.axis);
  rectification.setNumberOfThreads(controls.threads);
  rectification.setProgressCallback(controls.progress);
  for (std::size_t i = 0; i < scans.clouds.size(); ++i)
    rectification.addPointCloud(
        scans.clouds[i], scans.trajectory.poses[i], scans.weights[i]);
  rectification.compute();
  timer.finish("rectify");
  Poses poses;
  for (std::size_t i = 0; i < rectification.getNumberOfPointClouds(); ++i)
    poses.push_back(rectification.getPose(i));
  const EntropyRectificationReport& report = rectification.getReport();
  if (options.write_map)
    savePointCloud(folder.path("map.pcd"), echoesOf(scans, poses, memoryCheck()));
  writePoses(scans.trajectory, poses, folder);
  savePictures(
      drawRectification(
          scans.clouds, scans.trajectory.poses, poses, levelled.axis, report.steps),
      [&](const char* name) { return folder.path(name); });
  saveCorrectedLog(folder.path("corrected.log"), scans, poses);
  savePlanarPoses(folder.path("poses_2d.txt"), scans, poses);
  stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  log.warn(levelled.remarks);
  log.warn(report.remarks);
  tellRectification(options, levelled, report, log);
  tellFiles(options, {}, log);
}

} // namespace pcl::acmap
