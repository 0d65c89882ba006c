#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <map>
#include <mutex>
#include <string>

namespace pcl::acmap {

/** \brief Times and recorded poses of the depth camera of an RGB-D sequence. There are no poses
 * if the sequence has none.
 * \throws InputFileException as \ref pcl::loadPose */
Trajectory
recordedTrajectory(const RgbdSequence& sequence);

/** \brief Changes with the names, sizes and times of the images, and with the cameras. */
std::string
stateOfRgbd(const RgbdSequence& sequence, const RgbdCameras& cameras);

/** \brief Reads frames of an RGB-D sequence as if they were PCD files of a sequence of
 * observations. Thread-safe. */
class RgbdReader {
public:
  /** \param[in] trajectory poses of the observations in the map; may be empty
   * \param[in] threads 0 for all */
  RgbdReader(const RgbdSequence& sequence,
             RgbdCameras cameras,
             const Trajectory& trajectory,
             unsigned threads);

  /** \brief Reads a frame.
   * \param[in] name of its observation, as \ref observationName
   * \throws InputFileException as \ref pcl::loadRgbdObservation; all frames must have
   * the sizes of the first one that was read */
  PointCloudFile
  read(const std::string& name);

  /** \brief Reads the depths of a frame alone, as points of the observation's frame, organized as
   * the depth image.
   * \throws InputFileException if the depth image is missing or malformed */
  PointCloudFile
  readMeasured(const std::string& name) const;

private:
  struct PosedFrame {
    RgbdFrame frame;
    Eigen::Isometry3d T_map_camera;
  };

  std::map<std::string, PosedFrame> frames_;
  RgbdCameras cameras_;
  unsigned threads_;
  std::mutex mutex_;
  RgbdImageSizes sizes_; ///< guarded by mutex_
};

} // namespace pcl::acmap
