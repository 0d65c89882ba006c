#include "rectification_options.h"

#include "energy_curve.h"
#include "map_observations.h"
#include "memory.h"
#include "output_target.h"
#include "plan_picture.h"
#include "pose_adjustment.h"
#include "stage_reports.h"

#include <pcl/core/carmen_log.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/impl/rectification_kernel.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;
using Poses = std::vector<Eigen::Isometry3d>;
using Rectification = EntropyRectification<PointNormal>;

constexpr double degrees = 180 / 3.14159265358979323846;

const char*
outcomeName(RectificationOutcome outcome)
{
  return nameIn(rectification_outcome_names, outcome);
}

/** The steps as columns, since there may be thousands of them. */
Json
columnsOf(const std::vector<RectificationStep>& steps)
{
  Json columns;
  visitFields(RectificationStep(), [&](const Field& field, const auto&) {
    columns[field.name] = Json::array();
  });
  for (const RectificationStep& step : steps)
    visitFields(step, [&](const Field& field, const auto& value) {
      columns[field.name].push_back(value);
    });
  return columns;
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
                           {"votes"},
                           {"accepted_moves"},
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

/** Reports the outcome as lines of the summary and, if it is Refused or Undetermined, as
 * a warning. */
void
tellOutcome(const EntropyRectificationReport& report, StageLog& log)
{
  for (const std::string& remark : report.remarks)
    if (remark != report.reason)
      log.warn(remark);
  log.tell(outcomeName(report.outcome), report.reason);
  if (report.outcome == RectificationOutcome::Refused ||
      report.outcome == RectificationOutcome::Undetermined)
    log.warn("the poses are as they came: " + report.reason);
  if (report.before.rays > 0)
    tellEvidence(report, log);
  log.tell("moved",
           "at most " + shortNumber(largestOf(report.moved)) + " m and " +
               shortNumber(degrees * largestOf(report.turned)) + " degrees");
}

std::string
nameOfAxis(const Eigen::Vector3d& axis)
{
  int number = 0;
  axis.cwiseAbs().maxCoeff(&number);
  return std::string(axis[number] < 0 ? "-" : "") + "xyz"[number];
}

/** Do all poses have the same height, and rotate about y only, as for motions on a
 * floor? */
bool
areOnAFloor(const Poses& poses)
{
  constexpr double level = 1 - 1e-8, height = 1e-4; // cosine, metres
  return poses.size() > 1 &&
         std::all_of(poses.begin(), poses.end(), [&](const Eigen::Isometry3d& pose) {
           const double rise = pose.translation().y() - poses[0].translation().y();
           return pose.linear()(1, 1) > level && std::abs(rise) < height;
         });
}

/** Levels the map and reports its vertical. The scans of a log are planar: theirs is y;
 * the paper's mode takes the map as it is. */
MapLevellingReport
level(const RectificationOptions& options,
      MapObservations& observations,
      const RunControls& controls,
      StageLog& log)
{
  constexpr double strong = 10; // degrees
  const bool is_on_a_floor = areOnAFloor(observations.trajectory.poses);
  MapLevelling<PointNormal> levelling;
  if (options.up)
    levelling.setUpDirection(*options.up);
  else if (observations.files.empty() ||
           options.stage.getMode() == RectificationMode::Paper)
    levelling.setUpDirection(-Eigen::Vector3d::UnitY());
  const MapLevellingReport report =
      levelObservations(levelling, observations, controls.threads);
  log.warn(report.remarks);
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
  if (tilt > strong && is_on_a_floor)
    log.warn(
        "the map was not level, but its poses turn about y only: where a hand held "
        "the camera, find them again with --6dof (of pcl_visual_egomotion or "
        "pcl_compact_mapping)");
  return report;
}

Rectification
rectify(const RectificationOptions& options,
        const MapObservations& observations,
        const Eigen::Vector3d& up,
        const RunControls& controls)
{
  Rectification rectification = options.stage;
  rectification.setUpDirection(up);
  rectification.setNumberOfThreads(controls.threads);
  rectification.setProgressCallback(controls.progress);
  for (std::size_t i = 0; i < observations.clouds.size(); ++i)
    rectification.addPointCloud(observations.clouds[i],
                                observations.trajectory.poses[i],
                                observations.weights[i]);
  rectification.compute();
  rectification.setProgressCallback({});
  return rectification;
}

/** Transforms the poses to a frame whose y axis points down, as plans have it. */
Poses
upright(const Eigen::Vector3d& up, Poses poses)
{
  for (Eigen::Isometry3d& pose : poses)
    pose = uprightRotation(up) * pose;
  return poses;
}

/** Extent of all poses and points, before and after. */
PlanExtent
extentOf(const MapObservations& observations, const Poses& before, const Poses& after)
{
  PlanContents contents;
  for (const Poses* all : {&before, &after})
    for (std::size_t i = 0; i < all->size(); ++i) {
      const Eigen::Isometry3d& T_plan_camera = (*all)[i];
      contents.addPlace(T_plan_camera.translation());
      for (const PointNormal& point : *observations.clouds[i])
        contents.addPoint(T_plan_camera * point.getVector3fMap().cast<double>());
    }
  return contents.extent();
}

/** Writes trajectories, plans, and if they are wanted the map and the observations.
 * \param[in] poses rectified, T_map_camera
 * \param[in] up plans are drawn perpendicularly to it */
void
writeOutputs(const RectificationOptions& options,
             const MapObservations& observations,
             const Poses& poses,
             const Eigen::Vector3d& up,
             const OutputFolder& folder,
             const RunControls& controls)
{
  MapRows map(options.write_map ? observations.points : 0,
              observations.colored,
              [](const std::string& work, std::size_t bytes, double) {
                requireMemory(bytes, work);
              });
  const Poses plan_before = upright(up, observations.trajectory.poses);
  const Poses plan_after = upright(up, poses);
  const PlanExtent extent = extentOf(observations, plan_before, plan_after);
  PlanPicture before(extent), after(extent);
  const Progress progress(controls.progress);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(poses.size()),
                  "writing");
    const std::shared_ptr<const PointCloudFile> observation = observations.load(i);
    if (options.write_map)
      map.append(*observation, poses[i], static_cast<std::int32_t>(i));
    const PointView points = observation->points();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3d in_camera = points[k].cast<double>();
      before.add(plan_before[i] * in_camera);
      after.add(plan_after[i] * in_camera);
    }
    if (options.write_observations) {
      PCLPointCloud2 cloud = observation->cloud;
      dropUnwritableFields(cloud);
      saveObservation(folder.path(observationName(i)), cloud, poses[i]);
    }
  }
  if (options.write_map)
    savePointCloud(folder.path("map.pcd"), map.finish());
  saveTrajectory(folder.path(trajectory_name), {observations.trajectory.stamps, poses});
  saveTrajectory(folder.path("trajectory_before.txt"), observations.trajectory);
  const RgbImage image_before = before.draw(plan_before, red);
  const RgbImage image_after = after.draw(plan_after, blue);
  savePng(folder.path("plan_before.png"), image_before);
  savePng(folder.path("plan_after.png"), image_after);
  savePng(folder.path("plan.png"), beside(image_before, image_after));
}

/** Writes the scans of a log with their new poses as a log, and the poses as a table. */
void
writeScans(std::vector<PlanarScan> scans,
           const Poses& poses,
           const OutputFolder& folder)
{
  std::vector<PlanarPose> before;
  std::ostringstream table;
  table.imbue(std::locale::classic());
  table.precision(std::numeric_limits<double>::max_digits10);
  table << "# stamp x y theta: seconds, metres, radians; x forward, y left, theta "
           "counter-clockwise\n";
  for (std::size_t i = 0; i < scans.size(); ++i) {
    before.push_back(scans[i].pose);
    const PlanarPose pose = planarPartOf(poses[i]);
    scans[i].pose = pose;
    table << scans[i].stamp << ' ' << pose.z << ' ' << 0.0 - pose.x << ' '
          << 0.0 - pose.theta << '\n';
  }
  saveCarmenLog(folder.path("corrected.log"), scans, before);
  const std::string text = table.str();
  OutputFile file(folder.path("poses_2d.txt"));
  file.write(text.data(), text.size());
  file.commit();
}

/** Rectifies the map of the observations that a function reads.
 * \param[in] posed sequence of the observations; nullptr for a log */
EstimatedPoses
rectifyMap(const RectificationOptions& options,
           const std::function<MapObservations()>& read,
           const ObservationSequence* posed,
           const RunControls& controls,
           StageLog& log)
{
  StepTimer timer(log.report);
  OutputFolder folder(options.output);
  if (folder.holds(options.input()) || folder.holds(options.input() + "/any"))
    throw UsageError(options.output + ": holds the input; name another folder");
  requireNoSequence(folder);
  MapObservations observations = read();
  if (observations.points == 0)
    throw NothingFound(options.input() + ": has no point");
  timer.finish("read");

  const MapLevellingReport levelled = level(options, observations, controls, log);
  const Rectification rectification =
      rectify(options, observations, levelled.axis, controls);
  timer.finish("rectify");

  Poses poses;
  for (std::size_t i = 0; i < rectification.getNumberOfPointClouds(); ++i)
    poses.push_back(rectification.getPose(i));
  if (options.six_degrees && posed) {
    const Trajectory rectified = {observations.trajectory.stamps, poses};
    poses = adjustPoses(posed->withPoses(observations.places, rectified),
                        observations.trajectory.poses,
                        rectification.getOdometryNoise(),
                        controls,
                        log)
                .poses;
    timer.finish("adjust");
  }
  const EntropyRectificationReport& report = rectification.getReport();
  writeOutputs(options, observations, poses, levelled.axis, folder, controls);
  if (!observations.scans.empty())
    writeScans(observations.scans, poses, folder);
  savePng(folder.path("energy.png"), energyPicture(report.steps));
  stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  tellOutcome(report, log);
  log.details.update(detailsOf(options, report));
  if (options.stage.getMode() == RectificationMode::Paper)
    log.details.update(
        Json{{"smoothing",
              rectification.getSmoothing().value_or(rectification.getBinSize())},
             {"votes", report.votes},
             {"accepted_moves", report.accepted_moves}});
  log.details["posed_files"] = observations.files;
  log.tellSeconds();
  log.tell("folder", options.output);
  return {observations.places,
          {observations.trajectory.stamps, poses},
          std::nullopt,
          levelled.found ? std::optional(levelled.axis) : std::nullopt};
}

} // namespace

EstimatedPoses
rectifyPoses(const RectificationOptions& options,
             const ObservationSequence& posed,
             const RunControls& controls,
             StageLog& log)
{
  const auto read = [&] {
    const bool is_raw = options.stage.getMode() == RectificationMode::Paper;
    return readObservations(posed, is_raw, options.skip_broken, controls, log);
  };
  return rectifyMap(options, read, &posed, controls, log);
}

void
rectifyScans(const RectificationOptions& options,
             const RunControls& controls,
             StageLog& log)
{
  const auto read = [&] { return readScans(options.log, options.every, log); };
  rectifyMap(options, read, nullptr, controls, log);
}

} // namespace pcl::acmap
