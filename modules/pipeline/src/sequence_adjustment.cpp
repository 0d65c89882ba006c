#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_types.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/pipeline/sequence_adjustment.h>

#include <cstring>
#include <memory>
#include <mutex>

namespace pcl {

namespace {

/** Coordinates of a file, and sigma if the point type has it. */
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
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointT& point = (*cloud)[i];
    point.getVector3fMap() = points[i];
    if constexpr (std::is_same_v<PointT, PointXYZRGBSigma>)
      if (sigma)
        std::memcpy(&point.sigma,
                    file.cloud.data.data() + i * file.cloud.point_step + sigma->offset,
                    sizeof(float));
  }
  return cloud;
}

template <typename PointT>
PlaneAdjustmentReport
adjustSequence(const ObservationSequence& sequence,
               PlaneAdjustment<PointT>& adjustment,
               Trajectory& trajectory)
{
  std::mutex reading; // of the cache of the sequence
  for (std::size_t i = 0; i < sequence.size(); ++i)
    adjustment.addPointCloudLoader(
        [&sequence, &reading, i] {
          std::shared_ptr<const PointCloudFile> file;
          {
            const std::lock_guard<std::mutex> lock(reading);
            file = sequence.load(i).file;
          }
          return measuredCloud<PointT>(*file);
        },
        trajectory.poses[i]);
  adjustment.compute();
  for (std::size_t i = 0; i < sequence.size(); ++i)
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
  Trajectory result;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    result.stamps.push_back(sequence.stamp(i));
    result.poses.push_back(sequence.load(i).T_map_camera);
  }
  const auto run = [&](auto adjustment) {
    adjustment.setNumberOfThreads(threads_);
    adjustment.setProgressCallback(progress_);
    adjustment.setOdometryNoise(odometry_);
    report_ = adjustSequence(sequence, adjustment, result);
  };
  if (acmap::findField(sequence.load(0).file->cloud, "sigma", PCLPointField::FLOAT32))
    run(PlaneAdjustment<PointXYZRGBSigma>());
  else
    run(PlaneAdjustment<PointXYZ>());
  trajectory = std::move(result);
}

} // namespace pcl
