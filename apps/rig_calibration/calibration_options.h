#pragma once

#include "tool.h"

#include <pcl/stereo/rig_calibrator_types.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Options of the user. */
struct CalibrationOptions {
  std::string session;                            ///< folder; empty: use the images
  std::array<std::vector<std::string>, 3> images; ///< paths by \ref RigCamera
  std::string board = "9x6";
  double square = 0.0; ///< metres
  std::string output;
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, CalibrationOptions& options);

/** \brief Creates the board from its text.
 * \throws UsageError when the text is malformed */
CalibrationBoard
boardOf(const CalibrationOptions& options);

/** \brief Refuses invalid combinations of lists.
 * \throws UsageError when there is no neighbour, the lists differ in length, an image
 * occurs twice, or a session is named too */
void
requireShots(const CalibrationOptions& options);

} // namespace pcl::acmap
