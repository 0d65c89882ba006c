#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/pipeline/rgbd_cameras.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Paths of a colour and a depth image that were taken together.
 * \ingroup pipeline */
struct RgbdFrame {
  std::string color; ///< path; empty: there are no colours
  std::string depth; ///< path
  double stamp = 0;  ///< seconds, or the frame's number if there is no time
  /** \brief Path of an image with 0 where the depth is not to be trusted; empty if there is
   * none. */
  std::string confidence;

  /** \brief Path of a 4 x 4 matrix T_world_camera; empty if there is none. */
  std::string pose_file;

  std::optional<Eigen::Isometry3d> T_world_camera; ///< set if it is already known
};

/** \brief Settings for opening a folder. \ingroup pipeline */
struct RgbdSequenceSettings {
  bool has_poses = true; ///< poses are used, if there are any
  /** \brief Seconds, maximum difference between stamps that match. */
  double max_stamp_gap = 0.02;
  bool has_camera = false; ///< the user set the camera
};

/** \brief Content of an RGB-D folder. \ingroup pipeline */
struct RgbdSequence {
  std::string folder; ///< path
  std::string layout; ///< name of the layout
  std::vector<RgbdFrame> frames;
  bool has_poses = true; ///< all frames have a pose
  Pinhole camera;        ///< of the depth images
  /** \brief Size of the images for which the camera is stated; 0 x 0 if it is not. The camera
   * is scaled to the images when the folder is opened. */
  ImageSize camera_size;
  double depth_scale = 1000.0; ///< number in a depth image that is one metre
  /** \brief Colours are known to have the pixels of the depth camera. */
  bool is_registered = false;
  std::optional<ColorCamera> color_camera; ///< if the layout defines a separate one
  std::size_t unmatched = 0;               ///< depth images without a colour image
  std::size_t unposed = 0; ///< frames that were left out because they have no pose
  std::vector<std::string> remarks; ///< warnings, such as an assumed camera

  /** \brief The cameras that the folder or its layout defines. */
  RgbdCameras
  cameras() const
  {
    return {camera, color_camera, {depth_scale, 0.0}, DepthSensor::Automatic};
  }
};

/** \brief Detects the layout of a folder and lists its frames. Of the images only the first
 * whole ones are read, for their sizes.
 * \throws InputFileException when it is no RGB-D folder, or a list in it is malformed
 * \throws EmptyInputException when no frame is left \ingroup pipeline */
ACMAP_EXPORT RgbdSequence
openRgbdSequence(const std::string& folder, const RgbdSequenceSettings& settings = {});

/** \brief Do the names in a folder look like those of an RGB-D recording in one of the
 * layouts? False if it cannot be listed. \ingroup pipeline */
ACMAP_EXPORT bool
isRgbdFolder(const std::string& folder);

/** \brief Pose of the depth camera, T_world_depth, from the file of the frame or already
 * known.
 * \throws InputFileException when the file is missing or is no rigid motion
 * \ingroup pipeline */
ACMAP_EXPORT Eigen::Isometry3d
loadPose(const RgbdFrame& frame);

} // namespace pcl
