#include "rectification_options.h"

#include "map_observations.h"
#include "output_target.h"
#include "rectification_outputs.h"
#include "stage_reports.h"

#include <pcl/mapping/entropy_rectification.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

const char*
outcomeName(RectificationOutcome outcome)
{
  switch (outcome) {
  case RectificationOutcome::Rectified:
    return "rectified";
  case RectificationOutcome::Kept:
    return "kept";
  case RectificationOutcome::Refused:
    return "refused";
  default:
    return "undetermined";
  }
}

nlohmann::ordered_json
jsonOf(const MapEvidence& evidence)
{
  return {{"rays", evidence.rays},
          {"near_contradictions", evidence.near_contradictions},
          {"far_contradictions", evidence.far_contradictions},
          {"near_rays", evidence.near_rays},
          {"far_rays", evidence.far_rays},
          {"mean_map_entropy", evidence.mean_map_entropy},
          {"orthogonal_variance", evidence.orthogonal_variance}};
}

/** The steps as columns, since there may be thousands of them. */
nlohmann::ordered_json
jsonOf(const std::vector<RectificationStep>& steps)
{
  nlohmann::ordered_json columns = {{"search", nlohmann::ordered_json::array()},
                                    {"bin_size", nlohmann::ordered_json::array()},
                                    {"entropy", nlohmann::ordered_json::array()},
                                    {"prior", nlohmann::ordered_json::array()},
                                    {"energy", nlohmann::ordered_json::array()}};
  for (const RectificationStep& step : steps) {
    columns["search"].push_back(step.search);
    columns["bin_size"].push_back(step.bin_size);
    columns["entropy"].push_back(step.entropy);
    columns["prior"].push_back(step.prior);
    columns["energy"].push_back(step.energy);
  }
  return columns;
}

void
addDetails(Tool& tool,
           const RectificationOptions& options,
           const EntropyRectificationReport& report)
{
  tool.details().update({{"input", options.input()},
                         {"output", options.output},
                         {"mode", nameOf(options.mode)},
                         {"bin_size", options.binSize()},
                         {"seed", options.seed},
                         {"observations", report.observations},
                         {"points", report.points},
                         {"invalid_points", report.invalid_points},
                         {"outcome", outcomeName(report.outcome)},
                         {outcomeName(report.outcome), report.reason},
                         {"evaluations", report.evaluations},
                         {"odometry_scale", report.odometry_scale},
                         {"strongest_action", report.strongest_action},
                         {"disagreement", report.disagreement},
                         {"before", jsonOf(report.before)},
                         {"after", jsonOf(report.after)},
                         {"moved", report.moved},
                         {"turned", report.turned},
                         {"steps", jsonOf(report.steps)},
                         {"rectification_seconds", secondsOf(report)}});
}

double
largestOf(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/** Fraction of rays before and after, in %. */
std::string
change(double before, double after, bool is_new)
{
  return shortNumber(100 * before) + (is_new ? " % before, " : " % (best candidate ") +
         shortNumber(100 * after) + (is_new ? " % after" : " %)");
}

void
tellEvidence(Tool& tool, const EntropyRectificationReport& report)
{
  const bool is_new = report.outcome == RectificationOutcome::Rectified;
  const MapEvidence& before = report.before;
  const MapEvidence& after = report.after;
  const auto near_confirmed = [](const MapEvidence& rays) {
    return rays.near_rays * (1 - rays.near_contradictions);
  };
  const auto far_confirmed = [](const MapEvidence& rays) {
    return rays.far_rays * (1 - rays.far_contradictions);
  };
  tool.tell("contradicted",
            "of the rays that near observations tell about " +
                change(before.near_contradictions, after.near_contradictions, is_new) +
                "; of those that far ones do " +
                change(before.far_contradictions, after.far_contradictions, is_new));
  tool.tell("confirmed",
            "of all rays by near observations " +
                change(near_confirmed(before), near_confirmed(after), is_new) +
                "; by far ones " +
                change(far_confirmed(before), far_confirmed(after), is_new));
}

/** \brief Reports the outcome as lines of the summary, in the JSON report and, if it is
 * Refused or Undetermined, as a warning. */
void
tellOutcome(Tool& tool,
            const RectificationOptions& options,
            const EntropyRectificationReport& report)
{
  for (const std::string& remark : report.remarks)
    if (remark != report.reason)
      tool.warn(remark);
  tool.tell(outcomeName(report.outcome), report.reason);
  if (report.outcome == RectificationOutcome::Refused ||
      report.outcome == RectificationOutcome::Undetermined)
    tool.warn("the poses are as they came: " + report.reason);
  if (report.before.rays > 0)
    tellEvidence(tool, report);
  tool.tell("moved",
            "at most " + shortNumber(largestOf(report.moved)) + " m and " +
                shortNumber(degrees * largestOf(report.turned)) + " degrees");
  addDetails(tool, options, report);
}

using Rectification = pcl::EntropyRectification<pcl::PointNormal>;

void
rectify(Tool& tool,
        const RectificationOptions& options,
        const MapObservations& observations,
        Rectification& rectification)
{
  rectification.setMode(options.mode);
  rectification.setBinSize(options.binSize());
  rectification.setSeed(options.seed);
  rectification.setOdometryNoise(options.odometry);
  rectification.setNumberOfThreads(tool.threads());
  for (std::size_t i = 0; i < observations.clouds.size(); ++i)
    rectification.addPointCloud(observations.clouds[i],
                                observations.trajectory.poses[i],
                                observations.weights[i]);
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    rectification.setProgressCallback(progress);
    rectification.compute();
  });
}

std::vector<Eigen::Isometry3d>
posesOf(const Rectification& rectification)
{
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < rectification.getNumberOfPointClouds(); ++i)
    poses.push_back(rectification.getPose(i));
  return poses;
}

/** \brief Do all poses have the same height, and rotate about y only, as for motions on
 * a floor? */
bool
areOnAFloor(const std::vector<Eigen::Isometry3d>& poses)
{
  constexpr double level = 1 - 1e-8, height = 1e-4; // cosine, metres
  return poses.size() > 1 &&
         std::all_of(poses.begin(), poses.end(), [&](const Eigen::Isometry3d& pose) {
           const double rise = pose.translation().y() - poses[0].translation().y();
           return pose.linear()(1, 1) > level && std::abs(rise) < height;
         });
}

/** \brief Warns of a map that is not level.
 * \return the normal of its floor; y of a level map */
Eigen::Vector3d
checkLevel(Tool& tool, const MapObservations& observations)
{
  constexpr double most = 10; // degrees
  constexpr double degrees = 180 / 3.14159265358979323846;
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d floor = floorNormalOf(observations).value_or(y);
  const double tilt = degrees * std::acos(std::min(1.0, floor.y()));
  if (tilt <= most)
    return y;
  tool.warn(
      "floors and ceilings lie " + std::to_string(std::lround(tilt)) +
      " degrees off the xz plane: the map is not level, and is rectified about its "
      "y axis all the same; plans are drawn along the floor" +
      (areOnAFloor(observations.trajectory.poses)
           ? "; its poses turn about y only: where a hand held the camera, find "
             "them again with --6dof (of pcl_visual_egomotion or "
             "pcl_compact_mapping)"
           : ""));
  return floor;
}

} // namespace

void
rectifyPoses(Tool& tool,
             const RectificationOptions& options,
             const std::optional<ObservationSequence>& posed)
{
  StepTimer timer(tool.report());
  OutputFolder folder(options.output);
  if (folder.holds(options.input()) || folder.holds(options.input() + "/any"))
    throw UsageError(options.output + ": holds the input; name another folder");
  requireNoSequence(folder);
  tool.requireReportWritable({options.input()});
  const MapObservations observations =
      posed ? readObservations(tool, *posed, options.skip_broken)
            : readScans(tool, options.log, options.every);
  if (observations.points == 0)
    throw NothingFound(options.input() + ": has no point");
  const Eigen::Vector3d floor =
      posed ? checkLevel(tool, observations) : Eigen::Vector3d::UnitY();
  timer.finish("read");

  Rectification rectification;
  rectify(tool, options, observations, rectification);
  timer.finish("rectify");

  const EntropyRectificationReport& report = rectification.getReport();
  writeOutputs(
      tool, options, observations, posesOf(rectification), floor, report.steps, folder);
  tool.stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  tellOutcome(tool, options, report);
  tool.details()["posed_files"] = observations.files;
  tool.tellSeconds();
  tool.tell("folder", options.output);
}

} // namespace pcl::acmap
