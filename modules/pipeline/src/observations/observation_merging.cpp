#include "poses/level_frame.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/ranked_work.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

namespace pcl {

namespace {

/** An observation, or why it cannot be read. */
struct Loaded {
  PosedObservation seen;
  std::exception_ptr error;
};

/** Reads some observations at the same time. */
std::vector<Loaded>
loadSome(const ObservationSequence& sequence, std::size_t first, std::size_t end)
{
  std::vector<Loaded> some(end - first);
  oneapi::tbb::parallel_for(first, end, [&](std::size_t i) {
    Loaded& loaded = some[i - first];
    try {
      loaded.seen = sequence.load(i);
    }
    catch (...) {
      loaded.error = std::current_exception();
    }
  });
  return some;
}

} // namespace

void
ObservationMerging::setMaximumPoints(std::size_t points)
{
  if (points == 0)
    acmap::refuseArgument("maximum number of points", 0, "at least 1");
  maximum_points_ = points;
}

void
ObservationMerging::compute(const ObservationSequence& sequence, MergedCloud& merged)
{
  acmap::withThreads(threads_, [&] { merge(sequence, merged); });
}

/** Appends observations up to a place of the sequence. */
void
ObservationMerging::add(const ObservationSequence& sequence,
                        std::size_t end,
                        acmap::MapRows& rows,
                        acmap::MergedRows& merged) const
{
  constexpr std::size_t at_a_time = 8;
  const acmap::Progress progress(progress_);
  std::vector<Loaded> some;
  for (std::size_t i = 0; i < end; ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(end), "reading");
    if (i % at_a_time == 0)
      some = loadSome(sequence, i, std::min(i + at_a_time, end));
    try {
      const Loaded loaded = std::exchange(some[i % at_a_time], {});
      if (loaded.error)
        std::rethrow_exception(loaded.error);
      const PosedObservation& seen = loaded.seen;
      merged.of_poses.insert(
          merged.of_poses.end(), seen.remarks.begin(), seen.remarks.end());
      const std::shared_ptr<const PointCloudFile> refined =
          refineQuantisedDepth(seen.file, sensor_, threads_);
      merged.refined += refined != seen.file ? 1 : 0;
      merged.are_colored = merged.are_colored && acmap::findColor(seen.file->cloud);
      const Eigen::Isometry3d pose =
          acmap::roundedPose(T_cloud_map_ * seen.T_map_camera);
      rows.append(*refined, pose, static_cast<std::int32_t>(merged.poses.size()));
      merged.poses.push_back(pose);
    }
    catch (const InputFileException& error) {
      if (!skip_broken_)
        throw;
      merged.remarks.push_back("left out: " + std::string(error.what()));
    }
    if (i + 1 == at_a_time) // with half more than if the others have as many points
      rows.reserve(3 * rows.size() / at_a_time * sequence.size() / 2);
  }
}

/** Appends what the other ranks have merged, in their order. */
void
ObservationMerging::addOfRanks(acmap::MapRows& rows, acmap::MergedRows& merged) const
{
  const acmap::Progress progress(progress_);
  while (const std::optional<acmap::MergedRows> part = ranked_work_->nextMerged()) {
    progress.tell(1, "reading of other ranks");
    const auto first = static_cast<std::int32_t>(merged.poses.size());
    merged.poses.insert(merged.poses.end(), part->poses.begin(), part->poses.end());
    merged.remarks.insert(
        merged.remarks.end(), part->remarks.begin(), part->remarks.end());
    merged.of_poses.insert(
        merged.of_poses.end(), part->of_poses.begin(), part->of_poses.end());
    merged.refined += part->refined;
    for (auto points = ranked_work_->nextRows(); !points.empty();
         points = ranked_work_->nextRows())
      rows.appendRows(points, first);
  }
}

acmap::MergedRows
ObservationMerging::mergeShare(const ObservationSequence& sequence)
{
  return acmap::withThreads(threads_, [&] {
    acmap::MapRows rows(0, true);
    acmap::MergedRows merged;
    add(sequence, sequence.size(), rows, merged);
    merged.cloud = rows.finish();
    acmap::returnFreeMemory();
    return merged;
  });
}

void
ObservationMerging::merge(const ObservationSequence& sequence, MergedCloud& merged)
{
  MergingReport report;
  report.remarks = sequence.remarks();
  acmap::MapRows rows(0, true, cost_callback_);
  rows.setMaximum(maximum_points_);
  acmap::MergedRows all;
  std::size_t own = 0;
  if (ranked_work_) {
    ranked_work_->startMerging(sensor_, T_cloud_map_, skip_broken_);
    add(sequence, ranked_work_->own(), rows, all);
    own = rows.size();
    addOfRanks(rows, all);
  }
  else
    add(sequence, sequence.size(), rows, all);
  if (all.poses.empty())
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(all.poses);
  report.every = rows.every();
  MergedCloud result;
  for (const Eigen::Isometry3d& pose : all.poses)
    result.viewpoints.push_back(pose.translation().cast<float>());
  result.cloud = rows.finish();
  if (ranked_work_ && report.every == 1) // else the others have other points
    result.cloud.setShares(ranked_work_->shares(own));
  report.observations = all.poses.size();
  report.refined = all.refined;
  report.points = result.cloud.size();
  report.remarks.insert(report.remarks.end(), all.remarks.begin(), all.remarks.end());
  if (!all.of_poses.empty())
    report.remarks.push_back(acmap::inOneLine(all.of_poses));
  merged = std::move(result);
  acmap::returnFreeMemory();
  report_ = std::move(report);
}

} // namespace pcl
