#pragma once

#include "tool.h"

#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/rig_calibrator_types.h>

namespace pcl::acmap {

/** \brief Puts the board images with their errors or reasons into the report and names
 * those that were left out. */
void
tellImages(Tool& tool, const RigCalibratorReport& calibrated);

/** \brief Summary, report and warnings of a calibration that was found. */
void
tellCalibration(Tool& tool,
                const RigCalibratorReport& calibrated,
                const TrinocularRig& rig);

} // namespace pcl::acmap
