#pragma once

#include "tool.h"

#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/rig_calibrator_types.h>

namespace pcl::acmap {

/** \brief Adds the board images with their errors, or the reasons why they were left
 * out, to the report, and reports those that were left out. */
void
tellImages(Tool& tool, const RigCalibratorReport& calibrated);

/** \brief Writes summary, report and warnings of a successful calibration. */
void
tellCalibration(Tool& tool,
                const RigCalibratorReport& calibrated,
                const TrinocularRig& rig);

} // namespace pcl::acmap
