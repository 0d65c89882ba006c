#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What is filmed, and by which cameras. */
struct FilmedScene {
  /** \brief Its rig is what frames are of once they are rectified, its views are places of
   * the rectified reference camera: truth refers to both. */
  SimulatedScene scene;

  std::optional<RigCalibration> cameras; ///< as they are built; else those of the rig
  std::string cameras_path;              ///< where they were read

  /** \brief Turns the built reference camera's frame into the rectified one's. */
  Eigen::Isometry3d T_rectified_reference = Eigen::Isometry3d::Identity();
};

/** \brief Puts cameras as they are built in place of the scene's rig.
 * \param[in] path of a `rig.yaml` with cameras
 * \return what is odd about them
 * \throws InputFileException when no cameras can be read, or none can be rectified
 * \throws MemoryRefused when their images do not fit */
std::vector<std::string>
setBuiltCameras(const std::string& path, FilmedScene& filmed);

/** \brief The grabber that films it.
 * \param[in] light its projector is placed in the rectified reference camera's frame
 * \throws InputFileException when the cameras cannot be simulated
 * \throws BadArgumentException as the grabber's first constructor */
std::unique_ptr<SimulatedRigGrabber>
grabberOf(const FilmedScene& filmed,
          const std::vector<RgbImage>& patterns,
          const SimulatedLight& light);

} // namespace pcl::acmap
