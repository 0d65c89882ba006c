#pragma once

#include "stage_log.h"

#include <pcl/pipeline/camera_path.h>
#include <pcl/pipeline/pose_convention_check.h>

#include <optional>

namespace CLI {
class App;
} // namespace CLI

namespace pcl::acmap {

/** \brief Adds --pose-convention and --pose-scale. */
void
addPoseReading(CLI::App& app, PoseConventionCheck& check);

/** \brief Tells how recorded poses were read, in a line and in the detail `pose_convention`.
 * \param[in] report none if there were no recorded poses */
void
tellPoseReading(const PoseConventionCheck& check,
                const std::optional<PoseConventionReport>& report,
                StageLog& log);

/** \brief Tells what the path of the camera is, in a line and in the detail `path`. */
void
tellPath(const CameraPathReport& report, StageLog& log);

} // namespace pcl::acmap
