#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A scene and the cameras that film it. */
struct FilmedScene {
  /** \brief The scene. Its rig is that of the rectified frames, its views are poses of
   * the rectified reference camera: the ground truth refers to both. */
  SimulatedScene scene;

  /** \brief Unrectified cameras; if not set, those of the rig. */
  std::optional<RigCalibration> cameras;
  std::string cameras_path; ///< path of their file

  /** \brief Transforms from the frame of the unrectified reference camera to the
   * rectified one. */
  Eigen::Isometry3d T_rectified_reference = Eigen::Isometry3d::Identity();
};

/** \brief Replaces the cameras of the scene's rig by unrectified ones.
 * \param[in] path of a `rig.yaml` with cameras
 * \return warnings about them
 * \throws InputFileException when no cameras can be read, or none can be rectified
 * \throws MemoryRefused when their images do not fit */
std::vector<std::string>
setBuiltCameras(const std::string& path, FilmedScene& filmed);

/** \brief Creates the grabber that films the scene.
 * \param[in] light its projector is given in the rectified reference camera's frame
 * \throws InputFileException when the cameras cannot be simulated
 * \throws BadArgumentException as the grabber's first constructor */
std::unique_ptr<SimulatedRigGrabber>
grabberOf(const FilmedScene& filmed,
          const std::vector<RgbImage>& patterns,
          const SimulatedLight& light);

} // namespace pcl::acmap
