#pragma once

#include "sensor_option.h"
#include "tool.h"

#include <pcl/pipeline/rgbd_sequence.h>

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Options of the user. */
struct ImportOptions {
  std::string input;
  std::string output;
  bool no_poses = false;
  bool skip_broken = false;
  std::string intrinsics;
  std::string color_camera;
  bool is_registered = false;
  std::optional<double> fx, fy, cx, cy; ///< pixels
  std::optional<double> depth_scale;    ///< number in a depth image that is one metre
  double max_depth = 0.0;               ///< metres; 0 for no limit
  DepthSensor sensor = DepthSensor::Automatic;
  std::size_t every = 1;
  double max_stamp_gap = 0.02; ///< seconds
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, ImportOptions& options);

/** \brief Settings for reading the folder. */
RgbdSequenceSettings
settingsOf(const ImportOptions& options);

/** \brief The camera of the user, otherwise that of the folder.
 * \throws InputFileException when its file has no camera */
Pinhole
cameraOf(const ImportOptions& options, const RgbdSequence& sequence);

/** \brief The colour camera of the user, otherwise that of the folder; none if colours
 * have the pixels of the depth camera.
 * \throws InputFileException when its file has no camera */
std::optional<ColorCamera>
colorCameraOf(const ImportOptions& options, const RgbdSequence& sequence);

} // namespace pcl::acmap
