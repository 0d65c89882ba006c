#pragma once

#include "rgbd_sequence.h"
#include "sensor_option.h"
#include "tool.h"

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What the user asks for. */
struct ImportOptions {
  std::string input;
  std::string output;
  bool no_poses = false;
  bool skip_broken = false;
  std::string intrinsics;
  std::string color_camera;
  bool is_registered = false;
  std::optional<double> fx, fy, cx, cy; ///< pixels
  std::optional<double> depth_scale;    ///< numbers in a metre
  double most_depth = 0.0;              ///< metres; 0 for no limit
  DepthSensor sensor = DepthSensor::Automatic;
  std::size_t every = 1;
  double most_stamp_gap = 0.02; ///< seconds
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, ImportOptions& options);

/** \brief What is asked of the folder. */
SequenceSettings
settingsOf(const ImportOptions& options);

/** \brief The camera that the user names, or else that of the folder.
 * \throws InputFileException when its file is none */
Pinhole
cameraOf(const ImportOptions& options, const RgbdSequence& sequence);

/** \brief The camera of the colours that the user names, or else that of the folder; none
 * where colours are taken from the depth's pixels.
 * \throws InputFileException when its file is none */
std::optional<ColorCamera>
colorCameraOf(const ImportOptions& options, const RgbdSequence& sequence);

} // namespace pcl::acmap
