#pragma once

#include "grabber_options.h"

#include <pcl/acquisition/digiclops_grabber.h>

#include <optional>

namespace pcl::acmap {

/** \brief Reads `r,h,v` in any order, as letters or words.
 * \return nothing for `auto`
 * \throws UsageError for anything else */
std::optional<ChannelOrder>
channelOrderOf(const std::string& text);

/** \brief Sets mode, rate, shutter, gain, trigger and channel order.
 * \throws UsageError, BadArgumentException for illegal values
 * \throws CameraException for settings that this camera does not support */
void
setUpCamera(DigiclopsGrabber& grabber, const GrabberOptions& options);

} // namespace pcl::acmap
