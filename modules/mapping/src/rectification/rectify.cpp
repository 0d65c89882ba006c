#include "../verdict/independent_estimate.h"
#include "mended_odometry.h"
#include "rectification_steps.h"
#include "remaining_error.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/mapping/impl/rectification_kernel.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace pcl::acmap {
namespace {

void
count(const std::vector<LevelledPoints>& observations,
      EntropyRectificationReport& report)
{
  report.observations = observations.size();
  for (const LevelledPoints& seen : observations) {
    report.points += seen.points.size();
    for (const Eigen::Vector3f& point : seen.points)
      report.invalid_points += !point.allFinite();
  }
}

void
tellMoves(const std::vector<PlanarPose>& before,
          const std::vector<PlanarPose>& after,
          EntropyRectificationReport& report)
{
  for (std::size_t i = 0; i < before.size(); ++i) {
    report.moved.push_back(
        std::hypot(after[i].x - before[i].x, after[i].z - before[i].z));
    report.turned.push_back(
        std::abs(std::remainder(after[i].theta - before[i].theta, 2 * M_PI)));
  }
}

/** The first observations: their walls have the orientation of the first pose, without
 * drift. */
template <typename Value>
std::vector<Value>
firstOf(const std::vector<Value>& values)
{
  return {values.begin(),
          values.begin() +
              static_cast<std::ptrdiff_t>(std::min(neighbours, values.size()))};
}

/** Poses translated by \a times the vector from the origin to a place. */
std::vector<PlanarPose>
shifted(std::vector<PlanarPose> poses, double times, const PlanarPose& place)
{
  for (PlanarPose& pose : poses) {
    pose.x += times * place.x;
    pose.z += times * place.z;
  }
  return poses;
}

/** The corner of the bin that contains a place: shifted by it, points remain in their
 * bins. */
PlanarPose
cornerOfBin(const PlanarPose& place, double bin_size)
{
  return {bin_size * std::floor(place.x / bin_size),
          bin_size * std::floor(place.z / bin_size),
          0};
}

/** Searches in a map whose building is aligned with the axes, if projections are
 * used. */
std::vector<PlanarPose>
searchAlongAxes(const RectificationTask& task,
                EntropySearch& search,
                const std::vector<PlanarPose>& poses)
{
  const RectificationSettings& settings = task.settings;
  double turn = 0;
  if (projectionWeight(settings) > 0) {
    const EntropyLevel level{
        settings.bin_size, 1, false, false}; // coarse bins would be 1 degree off
    turn = buildingDirection(
        firstOf(search.cells(level)), firstOf(poses), search.entropySettings(level));
  }
  // Near the origin there is less rounding.
  const bool is_paper = settings.mode == RectificationMode::Paper;
  const PlanarPose middle =
      is_paper ? cornerOfBin(poses.front(), settings.bin_size) : poses.front();
  const std::vector<PlanarPose> start = turnedMap(shifted(poses, -1, middle), turn);
  const std::vector<PlanarPose> found =
      is_paper ? votingSearch(task, start) : guardedSearch(task, search, start);
  return task.report.outcome == RectificationOutcome::Rectified
             ? shifted(turnedMap(found, -turn), 1, middle)
             : poses;
}

/** Tells how far the poses of the map that is rectified or kept may still be wrong. */
void
tellRemainingError(const RectificationTask& task,
                   const std::vector<PlanarPose>& given,
                   const std::vector<PlanarPose>& result)
{
  constexpr double contradicted = 0.2; // share of rays, where parts lie wrongly
  constexpr double told = 0.1;         // metres
  constexpr double doubtful = 2; // moves: of a map that hardly changed it is no news
  constexpr double seen_again =
      0.2; // share of rays that end on walls of far observations
  EntropyRectificationReport& report = task.report;
  if (report.after.far_contradictions > contradicted) {
    report.remarks.emplace_back("parts of the map contradict each other: how far the "
                                "poses are wrong is not known");
    return;
  }
  const double scale = std::max(1.0, report.odometry_scale);
  report.expected_error = remainingError(task.observations,
                                         result,
                                         given,
                                         scaled(task.settings.odometry, scale, scale),
                                         task.settings.bin_size);
  const double left = report.expected_error.value_or(0);
  if (report.outcome == RectificationOutcome::Rectified && left > told &&
      report.after.far_rays < seen_again &&
      left < doubtful * *std::max_element(report.moved.begin(), report.moved.end()))
    report.remarks.push_back(
        "poses may still be wrong by " + shortNumber(left) +
        " m (95 %): no place is seen again, and the walls of neighbouring observations "
        "do "
        "not tell everywhere how far they are apart; for clouds in space, "
        "PlaneAdjustment "
        "(--6dof) also uses what floors, ceilings and small planes tell");
}

/** Reason why the observations do not determine their poses; empty if they do. */
std::string
whatHinders(EntropySearch& search,
            const std::vector<PlanarPose>& poses,
            double bin_size)
{
  if (poses.size() < 2)
    return "one observation: there is nothing that it could fit or not fit";
  const EntropyLevel level{4 * bin_size, 1, false, false};
  MapEntropyReport told;
  const MapEntropyTerms terms =
      mapEntropy(search.cells(level), poses, search.entropySettings(level), told);
  return terms.points == 0 || terms.dimensions < 2 ? told.remarks.front() : "";
}

/** Are parts laid onto each other that saw no wall in common before? They may be copies of
 * each other, which no ray contradicts. */
bool
isFolded(const EntropyRectificationReport& report)
{
  constexpr double none = 0.01, many = 0.2; // shares of the rays
  return report.before.far_rays < none && report.after.far_rays > many;
}

/** Keeps the given poses unless the verdict says that others are better.
 * \param[in] are_scans Otherwise the verdict's estimate knows too little of the views to
 * prove anything, and only what it contradicts is refused, or what may be copies. */
std::vector<PlanarPose>
judged(const IndependentEstimate& estimate,
       const std::vector<PlanarPose>& given,
       std::vector<PlanarPose> result,
       bool are_scans,
       EntropyRectificationReport& report)
{
  constexpr double certain = 0.95; // probability
  if (report.outcome != RectificationOutcome::Rectified) {
    report.verdict = estimate.judgeGiven();
    // unless the rays contradict all, they outweigh a wrong match of two scans
    if (report.outcome != RectificationOutcome::Refused &&
        report.verdict->outcome == VerdictOutcome::Contradicted)
      report.verdict->outcome = VerdictOutcome::Undetermined;
    return given;
  }
  MapVerdictReport& verdict = report.verdict.emplace(estimate.judge(result));
  if (!are_scans && verdict.probability_worse < certain &&
      verdict.outcome == VerdictOutcome::Contradicted)
    verdict.outcome = VerdictOutcome::Undetermined; // a wrong match of two views
  const bool is_worse = verdict.outcome == VerdictOutcome::Contradicted;
  const bool is_folded = !are_scans && isFolded(report);
  if (verdict.outcome == VerdictOutcome::Consistent ||
      !(are_scans || is_worse || is_folded))
    return result;
  if (is_folded)
    verdict.reasons.insert(
        verdict.reasons.begin(),
        "ambiguous: parts that had no wall in common are laid onto each "
        "other, and may only look alike");
  report.outcome =
      is_worse ? RectificationOutcome::Refused : RectificationOutcome::Undetermined;
  report.reason = is_worse
                      ? "an estimate from neighbouring observations, places that are "
                        "seen again and the odometry contradicts the rectified poses"
                      : "nothing proves that the rectified poses are better";
  for (const std::string& reason : verdict.reasons)
    report.reason += "; " + reason;
  report.refused_poses = std::move(result);
  return given;
}

} // namespace

std::vector<PlanarPose>
rectify(const std::vector<LevelledPoints>& observations,
        const std::vector<PlanarPose>& poses,
        const RectificationSettings& settings,
        const Progress& progress,
        EntropyRectificationReport& report)
{
  requirePoses(poses, observations.size());
  count(observations, report);
  std::optional<IndependentEstimate> estimate;
  RectificationSettings taken = settings;
  std::vector<PlanarPose> start = poses;
  const bool are_scans = areScans(observations);
  if (settings.mode == RectificationMode::Guarded && poses.size() > 1) {
    estimate.emplace(observations, poses, settings.odometry, settings.seed, progress);
    if (!settings.is_odometry_stated && are_scans)
      start = mendedOdometry(estimate->odometry(), poses, taken.odometry, report);
  }
  const RectificationTask task{observations, taken, progress, report};
  EntropySearch search(task);
  std::vector<PlanarPose> result = poses;
  const bool is_hopeless = report.outcome == RectificationOutcome::Refused;
  if (!is_hopeless)
    report.reason = whatHinders(search, poses, settings.bin_size);
  if (report.reason.empty())
    result = searchAlongAxes(task, search, start);
  else
    measureQuality(observations, poses, report.before);
  if (report.outcome == RectificationOutcome::Undetermined || is_hopeless)
    report.after = report.before;
  if (report.outcome != RectificationOutcome::Rectified)
    result = poses;
  if (estimate)
    result = judged(*estimate, poses, std::move(result), are_scans, report);
  if (report.outcome == RectificationOutcome::Undetermined ||
      report.outcome == RectificationOutcome::Refused)
    report.remarks.push_back("the poses are as they came: " + report.reason);
  tellMoves(poses, result, report);
  if (report.outcome == RectificationOutcome::Rectified ||
      report.outcome == RectificationOutcome::Kept)
    tellRemainingError(task, poses, result);
  return result;
}

} // namespace pcl::acmap
