#include "part_of_progress.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_types.h>
#include <pcl/egomotion/revisit_detection.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/pipeline/sequence_adjustment.h>

#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace pcl {

namespace {

/** Coordinates of a file, and sigma and colours if the point type has them. */
template <typename PointT>
typename PointCloud<PointT>::ConstPtr
measuredCloud(const PointCloudFile& file)
{
  const acmap::PointView points = file.points();
  auto cloud = std::make_shared<PointCloud<PointT>>();
  cloud->resize(points.size());
  if (std::size_t{file.cloud.width} * file.cloud.height == points.size()) {
    cloud->width = file.cloud.width;
    cloud->height = file.cloud.height;
  }
  const PCLPointField* const sigma =
      acmap::findField(file.cloud, "sigma", PCLPointField::FLOAT32);
  const PCLPointField* const color = acmap::findColor(file.cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointT& point = (*cloud)[i];
    point.getVector3fMap() = points[i];
    if constexpr (std::is_same_v<PointT, PointXYZRGBSigma>) {
      const std::uint8_t* const row =
          file.cloud.data.data() + i * file.cloud.point_step;
      if (sigma)
        std::memcpy(&point.sigma, row + sigma->offset, sizeof point.sigma);
      if (color)
        std::memcpy(&point.rgba, row + color->offset, sizeof point.rgba);
    }
  }
  return cloud;
}

/** Reads observations for several threads: the cache of a sequence is not for them. */
class LockedReader {
public:
  explicit LockedReader(const ObservationSequence& sequence)
  : sequence_(sequence)
  {}

  template <typename PointT>
  auto
  loader(std::size_t i)
  {
    return [this, i] {
      std::shared_ptr<const PointCloudFile> file;
      {
        const std::lock_guard<std::mutex> lock(reading_);
        file = sequence_.load(i).file;
      }
      return measuredCloud<PointT>(*file);
    };
  }

private:
  const ObservationSequence& sequence_;
  std::mutex reading_;
};

bool
isImage(const PCLPointCloud2& cloud)
{
  return cloud.height > 1 && acmap::findColor(cloud);
}

template <typename PointT>
PlaneAdjustmentReport
adjustSequence(LockedReader& reader,
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
    throw BadArgumentException("there are " + std::to_string(before_.size()) +
                               " poses before the rectification of " +
                               std::to_string(sequence.size()) + " observations");
  Trajectory result;
  bool has_images = true;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const PosedObservation seen = sequence.load(i);
    result.stamps.push_back(sequence.stamp(i));
    result.poses.push_back(seen.T_map_camera);
    has_images = has_images && isImage(seen.file->cloud);
  }
  LockedReader reader(sequence);
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
