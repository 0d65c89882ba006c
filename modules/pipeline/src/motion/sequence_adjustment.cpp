#include "observations/locked_reader.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/egomotion/revisit_detection.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/pipeline/sequence_adjustment.h>

#include <optional>
#include <utility>
#include <vector>

namespace pcl {

namespace {

template <typename PointT>
PlaneAdjustmentReport
adjustSequence(acmap::LockedReader& reader,
               const std::vector<Revisit>& revisits,
               PlaneAdjustment<PointT>& adjustment,
               Trajectory& trajectory)
{
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i)
    adjustment.addPointCloudLoader(reader.template loader<PointT>(i),
                                   trajectory.poses[i]);
  for (const Revisit& revisit : revisits)
    adjustment.addRevisit(revisit.earlier,
                          revisit.later,
                          revisit.estimate.T_target_source,
                          revisit.estimate.covariance);
  adjustment.compute();
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i)
    trajectory.poses[i] = adjustment.getPose(i);
  return adjustment.getReport();
}

} // namespace

void
SequenceAdjustment::setOdometryNoise(const OdometryNoise& noise)
{
  acmap::requireOdometryNoise(noise);
  odometry_ = noise;
}

void
SequenceAdjustment::compute(const ObservationSequence& sequence, Trajectory& trajectory)
{
  if (!before_.empty() && before_.size() != sequence.size())
    throw acmap::BadArgument("there are " + std::to_string(before_.size()) +
                             " poses before the rectification of " +
                             std::to_string(sequence.size()) + " observations");
  Trajectory result;
  bool has_images = true;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const PosedObservation seen = sequence.load(i);
    result.stamps.push_back(sequence.stamp(i));
    result.poses.push_back(seen.T_map_camera);
    has_images = has_images && acmap::isImage(seen.file->cloud);
  }
  acmap::LockedReader reader(sequence);
  RevisitDetection<PointXYZRGBSigma> detection;
  std::optional<RevisitReport> revisits;
  if (has_images) {
    for (std::size_t i = 0; i < sequence.size(); ++i)
      detection.addPointCloudLoader(reader.loader<PointXYZRGBSigma>(i));
    detection.setNumberOfThreads(threads_);
    detection.setProgressCallback(acmap::partOf(progress_, 0, 0.5));
    detection.compute();
    revisits = detection.getReport();
  }
  const Trajectory given = result;
  const auto runFrom = [&](const std::vector<Eigen::Isometry3d>& start,
                           auto adjustment) {
    result.poses = start;
    adjustment.setNumberOfThreads(threads_);
    adjustment.setProgressCallback(acmap::partOf(progress_, revisits ? 0.5 : 0, 1));
    adjustment.setOdometryNoise(odometry_);
    report_ = adjustSequence(reader, detection.getRevisits(), adjustment, result);
    return report_.outcome == AdjustmentOutcome::Adjusted ||
           report_.outcome == AdjustmentOutcome::Kept;
  };
  const auto run = [&](const auto& adjustment) {
    if (before_.empty() || !runFrom(before_, adjustment))
      runFrom(given.poses, adjustment);
  };
  if (acmap::findField(sequence.load(0).file->cloud, "sigma", PCLPointField::FLOAT32))
    run(PlaneAdjustment<PointXYZRGBSigma>());
  else
    run(PlaneAdjustment<PointXYZ>());
  revisits_ = std::move(revisits);
  trajectory = std::move(result);
}

} // namespace pcl
