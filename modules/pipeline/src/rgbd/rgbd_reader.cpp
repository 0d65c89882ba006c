#include "rgbd/rgbd_reader.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/pipeline/fingerprint.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/stage_store.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <utility>

namespace pcl::acmap {

Trajectory
recordedTrajectory(const RgbdSequence& sequence)
{
  Trajectory trajectory;
  for (const RgbdFrame& frame : sequence.frames) {
    trajectory.stamps.push_back(frame.stamp);
    if (sequence.has_poses)
      trajectory.poses.push_back(loadPose(frame));
  }
  return trajectory;
}

std::string
stateOfRgbd(const RgbdSequence& sequence, const RgbdCameras& cameras)
{
  Fingerprint hash;
  const auto addPinhole = [&hash](const Pinhole& camera) {
    for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy})
      hash.add(&value, sizeof value);
  };
  addPinhole(cameras.depth);
  if (cameras.color) {
    addPinhole(cameras.color->pinhole);
    hash.add(cameras.color->T_depth_color.matrix());
  }
  hash.add(&cameras.meaning.scale, sizeof cameras.meaning.scale);
  hash.add(&cameras.meaning.max_depth, sizeof cameras.meaning.max_depth);
  hash.add(&cameras.sensor, sizeof cameras.sensor);
  for (const RgbdFrame& frame : sequence.frames)
    for (const std::string* path : {&frame.color, &frame.depth, &frame.confidence})
      hash.add(stateOfFile(*path));
  return hash.text();
}

RgbdReader::RgbdReader(const RgbdSequence& sequence,
                       RgbdCameras cameras,
                       const Trajectory& trajectory,
                       unsigned threads)
: cameras_(std::move(cameras))
, threads_(threads)
{
  for (std::size_t i = 0; i < sequence.frames.size(); ++i)
    frames_[observationName(i)] = {
        sequence.frames[i],
        trajectory.poses.empty() ? Eigen::Isometry3d::Identity() : trajectory.poses[i]};
}

PointCloudFile
RgbdReader::read(const std::string& name)
{
  const PosedFrame& posed = frames_.at(name);
  RgbdImageSizes sizes;
  {
    const std::lock_guard lock(mutex_);
    sizes = sizes_;
  }
  RgbdObservation observation =
      loadRgbdObservation(posed.frame, cameras_, sizes, threads_);
  {
    const std::lock_guard lock(mutex_);
    sizes_ = observation.sizes;
  }
  PointCloudFile file;
  file.cloud = std::move(observation.cloud);
  const Eigen::Quaterniond orientation(posed.T_map_camera.linear());
  file.sensor_origin = posed.T_map_camera.translation().cast<float>();
  file.sensor_orientation = orientation.cast<float>().normalized();
  return file;
}

PointCloudFile
RgbdReader::readMeasured(const std::string& name) const
{
  const GrayImage16 depth = loadGrayImage16(frames_.at(name).frame.depth);
  const Eigen::Isometry3f T_observation_depth =
      frameOfObservations(cameras_).inverse().cast<float>();
  PointCloud<PointXYZ> points;
  for (const Eigen::Vector3f& measured :
       measuredPoints(depth, cameras_.depth, cameras_.meaning)) {
    const Eigen::Vector3f point = T_observation_depth * measured;
    points.push_back(PointXYZ(point.x(), point.y(), point.z()));
  }
  points.width = static_cast<std::uint32_t>(depth.width);
  points.height = static_cast<std::uint32_t>(depth.height);
  PointCloudFile file;
  toPCLPointCloud2(points, file.cloud);
  return file;
}

} // namespace pcl::acmap
