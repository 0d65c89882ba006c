#pragma once

#include "tool.h"

#include <pcl/stereo/rig_calibrator_types.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What the user asks for. */
struct CalibrationOptions {
  std::string session;                            ///< folder; empty: the images
  std::array<std::vector<std::string>, 3> images; ///< paths by \ref RigCamera
  std::string board = "9x6";
  double square = 0.0; ///< metres
  std::string output;
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, CalibrationOptions& options);

/** \brief The board that is meant.
 * \throws UsageError when its text is none */
CalibrationBoard
boardOf(const CalibrationOptions& options);

/** \brief Refuses lists that do not go together.
 * \throws UsageError when there is no neighbour, the lists differ in length, an image
 * stands twice, or a session is named too */
void
requireShots(const CalibrationOptions& options);

} // namespace pcl::acmap
