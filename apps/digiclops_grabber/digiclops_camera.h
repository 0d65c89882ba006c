#pragma once

#include "grabber/grabber_options.h"

#include <pcl/acquisition/channel_order.h>

namespace pcl::acmap {

/** \brief Options of the user. */
struct DigiclopsOptions : GrabberOptions {
  std::string mode; ///< `FORMAT:MODE`; empty: chosen by the rig
  std::string trigger = "off";
  std::string channel_order = "auto";
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, DigiclopsOptions& options);

/** \brief Refuses options that exclude each other, and places for the results that
 * cannot be used.
 * \throws UsageError, OutputFileException naming them */
void
requireSense(Tool& tool, const DigiclopsOptions& options);

/** \brief Reads `r,h,v` in any order, as letters or words.
 * \return nothing for `auto`
 * \throws UsageError for anything else */
std::optional<ChannelOrder>
channelOrderOf(const std::string& text);

/** \brief Prints one line per camera on the USB.
 * \throws NothingFound when there is none
 * \throws CameraException when USB is not available */
void
listDigiclopsCameras(StageLog& log);

/** \brief Opens the camera of a rig, as \ref GrabbedCameraOpener. */
std::unique_ptr<GrabbedCamera>
openDigiclopsCamera(const DigiclopsOptions& options, const TrinocularRig& rig);

} // namespace pcl::acmap
