#include "rgbd/rgbd_reader.h"

#include <pcl/pipeline/fingerprint.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/stage_store.h>

#include <utility>

namespace pcl::acmap {

Trajectory
rgbdTrajectory(const RgbdSequence& sequence, const RgbdCameras& cameras)
{
  Trajectory trajectory;
  for (const RgbdFrame& frame : sequence.frames)
    trajectory.stamps.push_back(frame.stamp);
  if (!sequence.has_poses)
    return trajectory;
  Eigen::Isometry3d T_first_world = Eigen::Isometry3d::Identity();
  for (const RgbdFrame& frame : sequence.frames) {
    const Eigen::Isometry3d T_world_camera = loadPose(frame, cameras);
    if (trajectory.poses.empty()) {
      T_first_world = T_world_camera.inverse();
      trajectory.poses.push_back(Eigen::Isometry3d::Identity());
    }
    else {
      trajectory.poses.push_back(T_first_world * T_world_camera);
    }
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

} // namespace pcl::acmap
