#pragma once

#include "grabber_options.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/trinocular_file_grabber.h>

#include <memory>
#include <optional>

namespace pcl::acmap {

/** \brief What gives the frames: a camera, or a recording in its place. */
struct Device {
  shared_ptr<DigiclopsGrabber> camera;         ///< null for a recording
  shared_ptr<TrinocularFileGrabber> recording; ///< null for a camera
  TrinocularRig rig;                           ///< of the frames

  /** \brief The cameras as they are built, where the rig's file has them: frames are then
   * not rectified. */
  std::optional<RigCalibration> cameras;

  TrinocularGrabber&
  frames() const;

  shared_ptr<TrinocularGrabber>
  framesPointer() const;

  /** \brief Bytes of the images of a frame, at most. */
  std::size_t
  frameBytes() const;
};

/** \brief Opens the device, and sets a camera as the user wishes.
 * \throws NothingFound when there is no such camera
 * \throws CameraException when it cannot be opened or set
 * \throws UsageError, BadArgumentException for settings that no camera takes
 * \throws InputFileException when rig or recording cannot be read */
Device
openDevice(const GrabberOptions& options);

/** \brief A line for each camera on the USB.
 * \throws NothingFound when there is none
 * \throws CameraException when there is no USB to look at */
void
listCameras(Tool& tool);

} // namespace pcl::acmap
