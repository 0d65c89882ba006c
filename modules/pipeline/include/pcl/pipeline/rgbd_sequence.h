#pragma once

#include "color_camera.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Paths of a colour and a depth image that were taken together. */
struct RgbdFrame {
  std::string color; ///< path
  std::string depth; ///< path
  double stamp = 0;  ///< seconds, or the frame's number if there is no time

  /** \brief Path of a 4 x 4 matrix T_world_camera; empty if there is none. */
  std::string pose_file;

  std::optional<Eigen::Isometry3d> T_world_camera; ///< set if it is already known
};

/** \brief Settings for reading a sequence. */
struct SequenceSettings {
  bool has_poses = true; ///< poses are required
  /** \brief Seconds, maximum difference between stamps that match. */
  double max_stamp_gap = 0.02;
  bool has_camera = false; ///< the user set the camera
};

/** \brief Content of an RGB-D folder. */
struct RgbdSequence {
  std::string layout; ///< name of the layout
  std::vector<RgbdFrame> frames;
  Pinhole camera;
  double depth_scale = 1000.0; ///< number in a depth image that is one metre
  /** \brief Colours are known to have the pixels of the depth camera. */
  bool is_registered = false;
  std::optional<ColorCamera> color_camera; ///< if the layout defines a separate one
  std::size_t unmatched = 0;               ///< depth images without a colour image
  std::size_t unposed = 0; ///< frames that were left out because they have no pose
  std::vector<std::string> remarks;
};

/** \brief Detects the layout of a folder and lists its frames, without reading the
 * images.
 * \throws InputFileException when it is no RGB-D folder, or a list in it is malformed
 * \throws NothingFound when no frame is left */
RgbdSequence
openSequence(const std::string& folder, const SequenceSettings& settings);

/** \brief Opens the layout of TUM: rgb.txt, depth.txt, groundtruth.txt. */
RgbdSequence
openTumSequence(const std::string& folder, const SequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openTumSequence? */
bool
isTumSequence(const std::string& folder);

/** \brief Opens the layout of 7-Scenes: frame-000000.color.jpg, .depth.png,
 * .pose.txt. */
RgbdSequence
openSevenScenesSequence(const std::string& folder, const SequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openSevenScenesSequence? */
bool
isSevenScenesSequence(const std::string& folder);

/** \brief Pose of a frame, from its file or already known.
 * \throws InputFileException when the file is missing or is no rigid motion */
Eigen::Isometry3d
poseOf(const RgbdFrame& frame);

} // namespace pcl::acmap
