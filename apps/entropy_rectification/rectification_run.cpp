#include "rectification_options.h"

#include "output_target.h"
#include "pose_options.h"
#include "stage_reports.h"

#include <pcl/core/carmen_log.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/process_memory.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/pipeline/bag_scans.h>
#include <pcl/pipeline/chain.h>
#include <pcl/pipeline/input_kind.h>
#include <pcl/pipeline/laser_observations.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_writing.h>

#include <CLI/StringTools.hpp>

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
  const std::string reasons = CLI::detail::join(verdict.reasons, "; ");
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

/** Writes the map, and the observations if they are wanted.
 * \param[in] posed the observations at their new poses */
void
writeClouds(const RectificationOptions& options,
            const ObservationSequence& posed,
            const SequenceConsolidationReport& consolidated,
            const OutputFolder& folder,
            const RunControls& controls)
{
  MapRows map(consolidated.points, consolidated.colored, memoryCheck());
  const auto read = [&](std::size_t i) -> std::optional<ObservationToWrite> {
    const PosedObservation seen = posed.load(i);
    map.append(*seen.file, seen.T_map_camera, static_cast<std::int32_t>(i));
    if (!options.write_observations)
      return {};
    const PCLPointCloud2::Ptr cloud(new PCLPointCloud2(seen.file->cloud));
    dropUnwritableFields(*cloud);
    return {{cloud, seen.T_map_camera, 0, observationName(i)}};
  };
  writeObservations(
      folder, posed.size(), read, {partOf(controls.progress, rectified, 1), "writing"});
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

std::string
degreesText(double radians)
{
  return shortNumber(radians * 180 / M_PI) + " degrees";
}

/** \brief The scans of a log, with what is assumed of their angles. */
std::vector<PlanarScan>
scansOfLog(const RectificationOptions& options, StageLog& log)
{
  CarmenLog carmen = loadCarmenLog(options.log, options.laser_sweep);
  log.warn(carmen.remarks);
  const PlanarScan& first = carmen.scans.front();
  const std::string step = ", a beam each " + degreesText(std::abs(first.angle_step));
  if (carmen.sweep == 0)
    log.tell("sweep",
             degreesText(std::abs(first.angle_step) *
                         static_cast<double>(first.ranges.size() - 1)) +
                 step + ", as the log states");
  else
    log.tell("sweep",
             degreesText(carmen.sweep) + step +
                 (carmen.is_sweep_stated ? ", as stated"
                                         : ", assumed; --laser-fov states another"));
  return std::move(carmen.scans);
}

std::vector<PlanarScan>
allScans(const RectificationOptions& options, StageLog& log)
{
  if (inputKindOf(options.log) != InputKind::Bag)
    return scansOfLog(options, log);
  BagSettings settings = options.bag;
  settings.every = 1;
  BagScans read = loadBagScans(options.log, settings);
  log.warn(read.remarks);
  return std::move(read.scans);
}

/** Reads every n-th scan of a CARMEN log or of a bag. */
LaserObservations
readScans(const RectificationOptions& options, StageLog& log)
{
  std::vector<PlanarScan> all = allScans(options, log);
  const std::size_t scans = all.size();
  LaserObservations observations = observationsOf(std::move(all), options.bag.every);
  log.warn(observations.remarks);
  log.tell("read",
           std::to_string(observations.clouds.size()) + " of " + std::to_string(scans) +
               " scans, " + std::to_string(observations.points) + " echoes, " +
               std::to_string(observations.missing_beams) + " beams without");
  log.details["missing_beams"] = observations.missing_beams;
  return observations;
}

Json
detailsOf(const PlaneAdjustmentReport& report,
          const std::optional<RevisitReport>& revisits)
{
  const char* const outcome = nameIn(adjustment_outcome_names, report.outcome);
  Json details = fieldsOf(report,
                          {{"reason", outcome},
                           {"views"},
                           {"invalid_points"},
                           {"revisits_used"},
                           {"revisits_dropped"}});
  if (revisits) {
    details["revisits"] =
        fieldsOf(*revisits, {{"views"}, {"points"}, {"invalid_points"}});
    details["revisits"]["used"] = report.revisits_used;
    details["revisits"]["dropped"] = report.revisits_dropped;
  }
  return details;
}

void
tellRevisits(const RevisitReport& revisits,
             const PlaneAdjustmentReport& report,
             StageLog& log)
{
  log.tell("revisits",
           std::to_string(revisits.proposals) + " pairs of observations look alike, " +
               std::to_string(revisits.verified) + " are verified, " +
               std::to_string(report.revisits_used) + " used");
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
tellAdjustment(const PlaneAdjustmentReport& report,
               const std::optional<RevisitReport>& revisits,
               StageLog& log)
{
  log.tell(std::string("planes ") + nameIn(adjustment_outcome_names, report.outcome),
           report.reason);
  log.tell("thickness",
           "of planes seen by several observations " +
               shortNumber(report.thickness_before) + " m, adjusted " +
               shortNumber(report.thickness_after) + " m");
  log.tell("moved by planes", "at most " + shortNumber(largestOf(report.moved)) + " m");
  if (revisits)
    tellRevisits(*revisits, report, log);
  log.details["adjustment"] = detailsOf(report, revisits);
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
  Chain chain(std::move(settings));
  chain.setInput(posed, true);
  chain.setNumberOfThreads(controls.threads);
  chain.setProgressCallback(partOf(controls.progress, 0, rectified));
  const ChainState& state = chain.run("adjustment");
  const CompactMappingReport& report = state.report;
  timer.finish("rectify");
  const ObservationSequence& mapped = *state.observations;
  const Poses& poses = state.estimated.trajectory.poses;
  writeClouds(options, mapped, *report.consolidation, folder, controls);
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
  Rectification rectification = options.stage;
  rectification.setNumberOfThreads(controls.threads);
  rectification.setProgressCallback(controls.progress);
  const RectifiedLaser found =
      rectifyLaser(scans, levellingOf(options), std::move(rectification));
  timer.finish("rectify");
  savePointCloud(folder.path("map.pcd"), echoesOf(scans, found.poses, memoryCheck()));
  writePoses(scans.trajectory, found.poses, folder);
  savePictures(drawRectification(scans.clouds,
                                 scans.trajectory.poses,
                                 found.poses,
                                 found.levelling.axis,
                                 found.report.steps),
               [&](const char* name) { return folder.path(name); });
  saveCorrectedLog(folder.path("corrected.log"), scans, found.poses);
  savePlanarPoses(folder.path("poses_2d.txt"), scans, found.poses);
  stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  log.warn(found.levelling.remarks);
  log.warn(found.report.remarks);
  tellRectification(options, found.levelling, found.report, log);
  tellFiles(options, {}, log);
}

} // namespace pcl::acmap
