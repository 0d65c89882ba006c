#include "rectification_steps.h"

#include <pcl/core/exceptions.h>
#include <pcl/mapping/impl/rectification_kernel.h>

#include <algorithm>
#include <cmath>
#include <string>

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

} // namespace

std::vector<PlanarPose>
rectify(const std::vector<LevelledPoints>& observations,
        const std::vector<PlanarPose>& poses,
        const RectificationSettings& settings,
        const Progress& progress,
        EntropyRectificationReport& report)
{
  if (poses.size() != observations.size())
    throw acmap::BadArgument("each observation needs one pose");
  count(observations, report);
  const RectificationTask task{observations, settings, progress, report};
  EntropySearch search(task);
  std::vector<PlanarPose> result = poses;
  report.reason = whatHinders(search, poses, settings.bin_size);
  if (report.reason.empty())
    result = searchAlongAxes(task, search, poses);
  else
    measureQuality(observations, poses, report.before);
  if (report.outcome == RectificationOutcome::Undetermined)
    report.after = report.before;
  if (report.outcome == RectificationOutcome::Undetermined ||
      report.outcome == RectificationOutcome::Refused)
    report.remarks.push_back("the poses are as they came: " + report.reason);
  tellMoves(poses, result, report);
  return result;
}

} // namespace pcl::acmap
