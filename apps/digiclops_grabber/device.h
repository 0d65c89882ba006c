#pragma once

#include "grabber_options.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/trinocular_file_grabber.h>

#include <optional>

namespace pcl::acmap {

/** \brief The source of the frames: a camera, or a recording. */
struct Device {
  shared_ptr<DigiclopsGrabber> camera;         ///< null for a recording
  shared_ptr<TrinocularFileGrabber> recording; ///< null for a camera
  TrinocularRig rig;                           ///< rig of the frames

  /** \brief The unrectified cameras, if the rig's file has them: frames are then not
   * rectified. */
  std::optional<RigCalibration> cameras;
};

/** \brief Opens the device, and applies the settings of the user to a camera.
 * \throws NothingFound when there is no such camera
 * \throws CameraException when it cannot be opened or does not support a setting
 * \throws UsageError, BadArgumentException for settings that no camera supports
 * \throws InputFileException when rig or recording cannot be read */
Device
openDevice(const GrabberOptions& options);

/** \brief Prints one line per camera on the USB.
 * \throws NothingFound when there is none
 * \throws CameraException when USB is not available */
void
listCameras(StageLog& log);

/** \brief Reads `r,h,v` in any order, as letters or words.
 * \return nothing for `auto`
 * \throws UsageError for anything else */
std::optional<ChannelOrder>
channelOrderOf(const std::string& text);

} // namespace pcl::acmap
