#pragma once

#include "stage_log.h"
#include "tool.h"

#include <pcl/pipeline/rgbd_assessment.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <optional>
#include <string>

namespace CLI {
class App;
} // namespace CLI

namespace pcl::acmap {

/** \brief What the user states of an RGB-D recording. */
struct RgbdOptions {
  bool no_poses = false;
  std::string intrinsics;
  std::string color_camera;
  bool is_registered = false;
  std::optional<double> fx, fy, cx, cy; ///< pixels
  std::optional<double> depth_scale;    ///< number in a depth image that is one metre
  double max_depth = 0.0;               ///< metres; 0 for no limit
  double max_stamp_gap = RgbdSequenceSettings().max_stamp_gap; ///< seconds
};

/** \brief Adds the options of the cameras. */
void
addRgbdCameras(CLI::App& app, RgbdOptions& options);

/** \brief Adds --no-poses. */
void
addNoPoses(CLI::App& app, RgbdOptions& options);

/** \brief Adds --max-depth. */
void
addMaxDepth(CLI::App& app, RgbdOptions& options);

/** \brief Adds --max-stamp-gap. */
void
addStampGap(CLI::App& app, RgbdOptions& options);

/** \brief Settings for opening the folder. */
RgbdSequenceSettings
settingsOf(const RgbdOptions& options);

/** \brief The cameras of the user, otherwise those of the folder; no colour camera if
 * colours have the pixels of the depth camera. */
RgbdCameras
camerasOf(const RgbdOptions& options,
          const RgbdSequence& sequence,
          DepthSensor sensor = DepthSensor::Automatic);

/** \brief What was assumed and what contradicts it: warnings, each once with the option that
 * states another. */
std::vector<std::string>
rgbdRemarks(const RgbdOptions& options,
            const RgbdSequence& sequence,
            const RgbdCameras& cameras);

/** \brief What the file of the depth camera is, for the summary; nothing without one. */
std::string
intrinsicsText(const RgbdOptions& options, const RgbdSequence& sequence);

/** \brief The scale of the depths with its origin, for the summary. */
std::string
depthScaleText(const RgbdOptions& options,
               const RgbdSequence& sequence,
               const RgbdCameras& cameras);

} // namespace pcl::acmap
