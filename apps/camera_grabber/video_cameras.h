#pragma once

#include "grabber/grabber_options.h"

namespace pcl::acmap {

/** \brief Options of the user. */
struct CameraOptions : GrabberOptions {
  std::string format; ///< four characters; empty: as the cameras are set
  std::optional<unsigned> warm_up;
  std::optional<unsigned> discard;
  std::optional<double> max_change; ///< grey levels
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, CameraOptions& options);

/** \brief Refuses options that exclude each other, and places for the results that
 * cannot be used.
 * \throws UsageError, OutputFileException naming them */
void
requireSense(Tool& tool, const CameraOptions& options);

/** \brief Prints one line per camera of the system.
 * \throws NothingFound when there is none */
void
listVideoCameras(StageLog& log);

/** \brief Opens the cameras of a rig, as \ref GrabbedCameraOpener. */
std::unique_ptr<GrabbedCamera>
openVideoCameras(const CameraOptions& options, const TrinocularRig& rig);

} // namespace pcl::acmap
