#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_merging.h>

namespace pcl {

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
  const acmap::Progress progress(progress_);
  MergingReport report;
  report.remarks = sequence.remarks();
  acmap::MapRows rows(0, true, cost_callback_);
  rows.setMaximum(maximum_points_);
  MergedCloud result;
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                  "reading");
    try {
      const PosedObservation seen = sequence.load(i);
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
  }
  if (poses.empty())
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(poses);
  const auto file = std::make_shared<PointCloudFile>();
  report.every = rows.every();
  file->cloud = rows.finish();
  report.observations = poses.size();
  report.points = acmap::rowsOf(file->cloud);
  result.cloud = file;
  merged = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl
