#pragma once

#include "stage_log.h"
#include "tool.h"

#include <pcl/pipeline/rgbd_assessment.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/pipeline/rgbd_statement.h>

#include <string>

namespace CLI {
class App;
} // namespace CLI

namespace pcl::acmap {

/** \brief What the user states of an RGB-D recording. */
using RgbdOptions = RgbdStatement;

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

/** \brief What the file of the depth camera is, for the summary; nothing without one. */
std::string
intrinsicsText(const RgbdOptions& options, const RgbdSequence& sequence);

/** \brief The scale of the depths with its origin, for the summary. */
std::string
depthScaleText(const RgbdOptions& options,
               const RgbdSequence& sequence,
               const RgbdCameras& cameras);

} // namespace pcl::acmap
