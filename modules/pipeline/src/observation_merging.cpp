#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_merging.h>

#include <algorithm>
#include <exception>
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

void
ObservationMerging::merge(const ObservationSequence& sequence, MergedCloud& merged)
{
  constexpr std::size_t at_a_time = 8;
  const acmap::Progress progress(progress_);
  MergingReport report;
  report.remarks = sequence.remarks();
  acmap::MapRows rows(0, true, cost_callback_);
  rows.setMaximum(maximum_points_);
  MergedCloud result;
  std::vector<Eigen::Isometry3d> poses;
  std::vector<Loaded> some;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                  "reading");
    if (i % at_a_time == 0)
      some = loadSome(sequence, i, std::min(i + at_a_time, sequence.size()));
    try {
      const Loaded loaded = std::exchange(some[i % at_a_time], {});
      if (loaded.error)
        std::rethrow_exception(loaded.error);
      const PosedObservation& seen = loaded.seen;
      report.remarks.insert(
          report.remarks.end(), seen.remarks.begin(), seen.remarks.end());
      const std::shared_ptr<const PointCloudFile> refined =
          refineQuantisedDepth(seen.file, sensor_, threads_);
      report.refined += refined != seen.file ? 1 : 0;
      rows.append(*refined, seen.T_map_camera, static_cast<std::int32_t>(poses.size()));
      poses.push_back(seen.T_map_camera);
      result.viewpoints.push_back(seen.T_map_camera.translation().cast<float>());
    }
    catch (const InputFileException& error) {
      if (!skip_broken_)
        throw;
      report.remarks.push_back("left out: " + std::string(error.what()));
    }
    if (i + 1 == at_a_time) // with half more than if the others have as many points
      rows.reserve(3 * rows.size() / at_a_time * sequence.size() / 2);
  }
  if (poses.empty())
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(poses);
  report.every = rows.every();
  result.cloud = rows.finish();
  report.observations = poses.size();
  report.points = result.cloud.size();
  merged = std::move(result);
  acmap::returnFreeMemory();
  report_ = std::move(report);
}

} // namespace pcl
